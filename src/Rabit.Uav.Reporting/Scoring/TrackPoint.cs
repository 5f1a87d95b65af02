using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Reporting;

/// <summary>Where a track was at a time. A plain value.</summary>
/// <param name="Time">By the clock of the vehicle.</param>
/// <param name="Position">There; the altitude is not used.</param>
public readonly record struct TrackPoint(TimeSpan Time, GeodeticPosition Position);
