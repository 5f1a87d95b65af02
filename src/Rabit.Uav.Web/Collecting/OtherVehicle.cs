using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Web.Collecting;

/// <summary>Where another vehicle is that is received on our links. Immutable.</summary>
/// <param name="SystemId">Its MAVLink system id.</param>
/// <param name="Position">Where it is.</param>
/// <param name="HeightAboveHomeMetres">Above its own home.</param>
/// <param name="Heading">Clockwise from north; NaN where it is not known.</param>
/// <param name="ReceivedAt">When, by the clock of the run.</param>
internal sealed record OtherVehicle(
    byte SystemId, GeodeticPosition Position, double HeightAboveHomeMetres, Angle Heading, TimeSpan ReceivedAt);
