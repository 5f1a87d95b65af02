using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class NavigationTrackerTests
{
    // As recorded: a good estimate, one with a glitch of the satellites, one without them.
    [Theory]
    [InlineData(0x033F, null)]
    [InlineData(0x833F, "satellites contradict it")]
    [InlineData(0x00A7, "no horizontal position, it assumes that the vehicle does not move")]
    public void Update_EkfStatusReport_TakesFlagsAndTheGreatestRatio(int flags, string? fault)
    {
        NavigationStatus status = Take(new EkfStatusReport
        {
            Flags = (EkfStatusFlags)flags,
            VelocityVariance = 0.1f,
            PosHorizVariance = 0.4f,
            PosVertVariance = 0.2f,
            CompassVariance = 3,
        });
        Assert.Equal(fault, status.EstimatorFault);
        Assert.Equal(0.4, status.EstimatorRatio, 6);
    }

    [Theory]
    [InlineData(0.1f, float.NaN, 0.3f, 0.3)]
    [InlineData(float.NaN, float.NaN, float.NaN, double.NaN)]
    [InlineData(2f, 0.5f, 0.3f, 2)]
    public void Update_EstimatorStatus_IgnoresWhatIsNotUsed(float velocity, float position, float height, double ratio)
    {
        NavigationStatus status = Take(new EstimatorStatus
        {
            Flags = (EstimatorStatusFlags)0x33F,
            VelRatio = velocity,
            PosHorizRatio = position,
            PosVertRatio = height,
        });
        Assert.Equal(ratio, status.EstimatorRatio, 6);
    }

    // ISO 2533, table of pressure and height.
    [Theory]
    [InlineData(1013.25f, 0)]
    [InlineData(954.61f, 500)]
    [InlineData(898.76f, 1000)]
    [InlineData(540.20f, 5000)]
    public void Update_ScaledPressure_IsTheHeightInTheStandardAtmosphere(float hectopascals, double metres)
        => Assert.Equal(metres, Take(new ScaledPressure { PressAbs = hectopascals }).PressureHeightMetres, 0.5);

    [Theory]
    [InlineData(0f)]
    [InlineData(float.NaN)]
    [InlineData(1200f)]
    public void Update_PressureThatIsNone_IsNotTaken(float hectopascals)
        => Assert.Null(Take(new ScaledPressure { PressAbs = hectopascals }).PressureTime);

    private static NavigationStatus Take<T>(in T message)
        where T : struct, IMavlinkMessage
    {
        var tracker = new NavigationTracker();
        tracker.Update(AutopilotRig.FrameOf(message, TimeSpan.FromSeconds(2)));
        return tracker.Status;
    }
}
