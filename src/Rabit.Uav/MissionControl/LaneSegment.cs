namespace Rabit.Uav.MissionControl;

/// <summary>A straight segment of a lane, from one point to another. A plain value.</summary>
internal readonly struct LaneSegment(PlanePoint start, PlanePoint end)
{
    public PlanePoint Start { get; } = start;

    public PlanePoint End { get; } = end;

    public double Length => Start.DistanceTo(End);

    public double HeadingRadians => (End - Start).HeadingRadians;
}
