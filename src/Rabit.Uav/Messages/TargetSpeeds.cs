namespace Rabit.Uav.Messages;

/// <summary>
/// How fast targets go, metres per second and axis: one standard deviation, where nothing else is known of them.
/// </summary>
internal static class TargetSpeeds
{
    public const double WalkingMetresPerSecond = 1.5;

    public const double VehicleMetresPerSecond = 8;

    public static double Of(TargetMotion motion)
        => motion == TargetMotion.Vehicle ? VehicleMetresPerSecond : WalkingMetresPerSecond;
}
