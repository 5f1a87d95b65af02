namespace Rabit.Uav.Simulation;

/// <summary>What a target says of the heading. A plain value.</summary>
/// <param name="yaw">Radians clockwise from north; NaN: nothing is said.</param>
/// <param name="yawRate">Radians per second; NaN: nothing is said.</param>
internal readonly struct HeadingTarget(double yaw, double yawRate)
{
    public static HeadingTarget None => new(double.NaN, double.NaN);

    public double Yaw { get; } = yaw;

    public double YawRate { get; } = yawRate;
}
