namespace Rabit.Uav.MissionControl;

/// <summary>Flies one segment of a lane.</summary>
internal interface ILaneFollower
{
    /// <summary>How much of the segment has been flown.</summary>
    double FlownMetres { get; }

    /// <summary>Begins a segment.</summary>
    void Begin(MissionFlight flight, LaneSegment segment, double heightMetres);

    /// <summary>Updates the goal.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="isLate">Whether the time-out has passed.</param>
    /// <returns>Whether the segment is flown.</returns>
    bool Tick(MissionFlight flight, out bool isLate);
}
