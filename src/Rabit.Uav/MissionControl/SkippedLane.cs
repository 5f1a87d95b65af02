namespace Rabit.Uav.MissionControl;

/// <summary>A leg that was left out at the operator's command, with the ground beside it. A plain value.</summary>
/// <param name="Leg">The leg.</param>
/// <param name="HalfMetres">Half the width of the ground.</param>
internal readonly record struct SkippedLane(LaneSegment Leg, double HalfMetres);
