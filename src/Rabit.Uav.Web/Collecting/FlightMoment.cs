using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.Collecting;

/// <summary>What the managers had posted at one moment. Immutable.</summary>
internal sealed class FlightMoment
{
    /// <summary>By the clock of the run.</summary>
    public required TimeSpan Time { get; init; }

    public required VehicleState Vehicle { get; init; }

    public required MissionStatus Mission { get; init; }

    public required HealthReport Health { get; init; }

    public required ImagingStatus Imaging { get; init; }

    public required TrackList Tracks { get; init; }

    /// <summary>Texts of the autopilot, newest first.</summary>
    public required RecentItems<StatusText> Texts { get; init; }

    /// <summary>By their number. The same list until it is fetched again.</summary>
    public required IReadOnlyList<LinkStatus> Links { get; init; }

    /// <summary>In the order of the managers' names. The same list until it is fetched again.</summary>
    public required IReadOnlyList<ManagerMoment> Managers { get; init; }

    /// <summary>Other vehicles that are received.</summary>
    public required IReadOnlyList<OtherVehicle> Others { get; init; }
}
