namespace Rabit.Uav.MissionControl;

/// <summary>A straight segment of a lane, from one point to another. A plain value.</summary>
internal readonly struct LaneSegment(PlanePoint start, PlanePoint end)
{
    public PlanePoint Start { get; } = start;

    public PlanePoint End { get; } = end;

    public double Length => Start.DistanceTo(End);

    public double HeadingRadians => (End - Start).HeadingRadians;

    /// <summary>Distance of a point from the segment.</summary>
    public double DistanceTo(PlanePoint point)
    {
        PlanePoint way = End - Start;
        double squared = way.Dot(way);
        double along = squared > 0 ? System.Math.Max(0, System.Math.Min(1, (point - Start).Dot(way) / squared)) : 0;
        return point.DistanceTo(Start + (along * way));
    }
}
