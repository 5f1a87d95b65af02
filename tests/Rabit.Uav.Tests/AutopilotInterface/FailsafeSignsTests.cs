using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>What shows that a failsafe of the autopilot changed the mode, by recorded reports of health.</summary>
public class FailsafeSignsTests
{
    // Of ArduPilot in ap-rc-failsafe.
    private const uint Present = 0x5371FC2F;
    private const uint Enabled = 0x5361FC2F;

    private static readonly VehicleState Vehicle = new() { SystemStatus = MavState.Active };

    // ap-rc-failsafe, ap-battery-rtl and px4-battery-return, ap-fence-reboot: up to 0.4 s after the mode.
    [Theory]
    [InlineData(0x00010000u, "SYS_STATUS: RC_RECEIVER unhealthy")]
    [InlineData(0x02000000u, "SYS_STATUS: BATTERY unhealthy")]
    [InlineData(0x00100000u, "SYS_STATUS: GEOFENCE unhealthy")]
    public void Find_BecameUnhealthyBesideTheChange_IsAFailsafe(uint bit, string sign)
    {
        var signs = new FailsafeSigns();
        signs.TakeHealth(Status(0), At(10));
        Assert.Null(signs.Find(Vehicle, At(11)));
        signs.TakeHealth(Status(bit), At(11.4));

        Assert.Equal(sign, signs.Find(Vehicle, At(11)));
        Assert.Null(signs.Find(Vehicle, At(30)));
    }

    // Before arming (ap-guided, ap-fence-reboot), a plane without terrain (ap-plane), after a landing without a
    // position (px4-gps-loss).
    [Theory]
    [InlineData(0x10000000u)]
    [InlineData(0x00400000u)]
    [InlineData(0x00200000u)]
    public void Find_OtherBits_AreNoSign(uint bit)
    {
        var signs = new FailsafeSigns();
        signs.TakeHealth(Status(0), At(10));
        signs.TakeHealth(Status(bit), At(11));

        Assert.Null(signs.Find(Vehicle, At(11)));
    }

    [Fact]
    public void Find_NeverHealthyOrNotEnabled_IsNoSign()
    {
        var signs = new FailsafeSigns();
        signs.TakeHealth(Status(0x00010000), At(10));
        signs.TakeHealth(Status(0x00010000), At(11));
        SysStatus off = Status(0x02000000);
        off.OnboardControlSensorsEnabled &= ~MavSysStatusSensor.Battery;
        signs.TakeHealth(off, At(12));

        Assert.Null(signs.Find(Vehicle, At(11)));
    }

    private static SysStatus Status(uint unhealthy) => new()
    {
        OnboardControlSensorsPresent = (MavSysStatusSensor)(Present | unhealthy),
        OnboardControlSensorsEnabled = (MavSysStatusSensor)(Enabled | unhealthy),
        OnboardControlSensorsHealth = (MavSysStatusSensor)(Present & ~unhealthy),
    };

    private static TimeSpan At(double seconds) => TimeSpan.FromSeconds(seconds);
}
