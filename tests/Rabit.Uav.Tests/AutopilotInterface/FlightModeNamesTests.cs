using System;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class FlightModeNamesTests
{
    [Theory]
    [InlineData(MavType.Quadrotor, 0, "STABILIZE")]
    [InlineData(MavType.Hexarotor, 4, "GUIDED")]
    [InlineData(MavType.Helicopter, 6, "RTL")]
    [InlineData(MavType.Quadrotor, 17, "BRAKE")]
    [InlineData(MavType.FixedWing, 10, "AUTO")]
    [InlineData(MavType.FixedWing, 15, "GUIDED")]
    [InlineData(MavType.VtolTiltrotor, 19, "QLOITER")]
    [InlineData(MavType.FixedWing, 5, "FBWA")]
    [InlineData(MavType.GroundRover, 4, "HOLD")]
    [InlineData(MavType.SurfaceBoat, 5, "LOITER")]
    [InlineData(MavType.Submarine, 9, "SURFACE")]
    [InlineData(MavType.AntennaTracker, 2, "SCAN")]
    [InlineData(MavType.Airship, 2, "VELOCITY")]
    [InlineData(MavType.Quadrotor, 42, "mode 42")]
    [InlineData(MavType.Quadrotor, 8, "mode 8")]
    [InlineData(MavType.Rocket, 4, "mode 4")]
    [InlineData(MavType.Quadrotor, uint.MaxValue, "mode 4294967295")]
    public void NameOf_ArduPilot_DependsOnTheVehicle(MavType vehicle, uint customMode, string expected)
        => Assert.Equal(expected, NameOf(MavAutopilot.Ardupilotmega, vehicle, customMode));

    [Theory]
    [InlineData(0x0001_0000u, "MANUAL")]
    [InlineData(0x0002_0000u, "ALTCTL")]
    [InlineData(0x0003_0000u, "POSCTL")]
    [InlineData(0x0103_0000u, "POSCTL.ORBIT")]
    [InlineData(0x0204_0000u, "AUTO.TAKEOFF")]
    [InlineData(0x0304_0000u, "AUTO.LOITER")]
    [InlineData(0x0404_0000u, "AUTO.MISSION")]
    [InlineData(0x0504_0000u, "AUTO.RTL")]
    [InlineData(0x0604_0000u, "AUTO.LAND")]
    [InlineData(0x0006_0000u, "OFFBOARD")]
    [InlineData(0x0007_0000u, "STABILIZED")]
    [InlineData(0x6304_0000u, "mode 1661206528")]
    [InlineData(0x0000_0000u, "mode 0")]
    public void NameOf_Px4_IsMadeOfMainAndSubMode(uint customMode, string expected)
        => Assert.Equal(expected, NameOf(MavAutopilot.Px4, MavType.FixedWing, customMode));

    [Theory]
    [InlineData(MavAutopilot.Generic,
        MavModeFlag.CustomModeEnabled | MavModeFlag.AutoEnabled | MavModeFlag.GuidedEnabled, "AUTO")]
    [InlineData(MavAutopilot.Ppz, MavModeFlag.GuidedEnabled | MavModeFlag.StabilizeEnabled, "GUIDED")]
    [InlineData(MavAutopilot.Reflex, MavModeFlag.StabilizeEnabled | MavModeFlag.ManualInputEnabled, "STABILIZE")]
    [InlineData(MavAutopilot.Ardupilotmega, MavModeFlag.ManualInputEnabled, "MANUAL")]
    [InlineData(MavAutopilot.Px4, MavModeFlag.SafetyArmed, "PREFLIGHT")]
    [InlineData(MavAutopilot.Slugs, MavModeFlag.TestEnabled, "TEST")]
    public void NameOf_WithoutCustomMode_IsThatOfTheFlags(MavAutopilot autopilot, MavModeFlag flags, string expected)
        => Assert.Equal(expected, NameOf(autopilot, MavType.Quadrotor, 3, flags));

    [Theory]
    [InlineData(typeof(CopterMode), MavType.Quadrotor)]
    [InlineData(typeof(PlaneMode), MavType.FixedWing)]
    [InlineData(typeof(RoverMode), MavType.GroundRover)]
    [InlineData(typeof(SubMode), MavType.Submarine)]
    [InlineData(typeof(TrackerMode), MavType.AntennaTracker)]
    public void NameOf_EveryModeOfTheDefinitions_HasAName(Type modes, MavType vehicle)
    {
        foreach (object mode in Enum.GetValues(modes))
        {
            string name = NameOf(MavAutopilot.Ardupilotmega, vehicle, Convert.ToUInt32(mode, null));
            Assert.False(name.StartsWith("mode ", StringComparison.Ordinal), $"{mode} of {modes.Name}");
        }
    }

    [Fact]
    public void NameOf_SameUnknownMode_AllocatesNothing()
    {
        var names = new FlightModeNames();
        Heartbeat heartbeat = HeartbeatOf(
            MavAutopilot.Ardupilotmega, MavType.Quadrotor, 42, MavModeFlag.CustomModeEnabled);
        string first = names.NameOf(heartbeat);

        Assert.Equal(0, Allocated.By(() => Assert.Same(first, names.NameOf(heartbeat))));
    }

    [Fact]
    public void NameOf_ManyUnknownModes_KeepsTellingThemApart()
    {
        var names = new FlightModeNames();
        for (uint mode = 1000; mode < 2000; mode++)
            Assert.Equal($"mode {mode}", names.NameOf(
                HeartbeatOf(MavAutopilot.Ardupilotmega, MavType.Quadrotor, mode, MavModeFlag.CustomModeEnabled)));
    }

    private static string NameOf(
        MavAutopilot autopilot, MavType vehicle, uint customMode, MavModeFlag flags = MavModeFlag.CustomModeEnabled)
        => new FlightModeNames().NameOf(HeartbeatOf(autopilot, vehicle, customMode, flags));

    private static Heartbeat HeartbeatOf(MavAutopilot autopilot, MavType vehicle, uint customMode, MavModeFlag flags)
        => new() { Autopilot = autopilot, Type = vehicle, CustomMode = customMode, BaseMode = flags };
}
