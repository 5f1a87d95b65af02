using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>
/// Pilots and other ground stations on the vehicle's own second link, and what shows on the companion's.
/// </summary>
public class CommanderTests
{
    private const double At = 40;

    [Fact]
    public void PilotMode_ByName_IsReportedAtOnce()
    {
        using Ground ground = Fly(new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, Mode = "loiter" });
        FailsafeTests.RunTo(ground, At + 0.05);
        Assert.Equal(CopterMode.Loiter, (CopterMode)ground.Heartbeat.CustomMode);
        Assert.InRange(ground.All<Heartbeat>().Last().Time.TotalSeconds - At, 0, 0.03);
    }

    [Fact]
    public void PilotMode_BySwitch_IsTakenWhenTheSwitchHasBeenStable()
    {
        using Ground ground = Fly(
            new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, Mode = "BRAKE", BySwitch = true });
        FailsafeTests.RunTo(ground, At + 0.18);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        FailsafeTests.RunTo(ground, At + 0.25);
        Assert.Equal(CopterMode.Brake, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void PilotMode_BySwitchWithoutRadio_IsNothing()
    {
        using Ground ground = Fly(
            new ScriptedFault { Kind = ScriptedFaultKind.RcLost },
            new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, Mode = "BRAKE", BySwitch = true });
        FailsafeTests.RunTo(ground, At + 0.5);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void ChannelsOverride_OtherPosition_TakesItsMode()
    {
        using var ground = new Ground(new SimulationOptions
        {
            Parameters = FailsafeTests.Parameters([("FLTMODE1", 4), ("FLTMODE5", 5)]),
        });
        ground.TakeOff(10);
        Switch(ground, 1100);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        Switch(ground, 1685, system: 7);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        Switch(ground, 1685);
        Assert.Equal(CopterMode.Loiter, (CopterMode)ground.Truth.CustomMode);
        Switch(ground, 1100);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void ChannelsOverride_AfterTheSwitch_TheLastOneCounts()
    {
        using Ground ground = Fly(
            new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, Mode = "BRAKE", BySwitch = true });
        Switch(ground, 1100);
        FailsafeTests.RunTo(ground, At + 0.5);
        Assert.Equal(CopterMode.Brake, (CopterMode)ground.Truth.CustomMode);
        Switch(ground, 1685);
        Assert.Equal(CopterMode.Stabilize, (CopterMode)ground.Truth.CustomMode);
        ground.Run(2);
        Assert.Equal(CopterMode.Stabilize, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void Heartbeat_RequestedOrAtAnotherInterval_IsSent()
    {
        using var ground = new Ground();
        ground.Run(1.5);
        int before = ground.Count<Heartbeat>();
        for (int request = 0; request < 5; request++)
            Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.RequestMessage, Heartbeat.MavlinkId));
        Assert.Equal(before + 5, ground.Count<Heartbeat>());
        Assert.Equal(MavResult.Accepted, ground.Stream(Heartbeat.MavlinkId, 5));
        ground.Forget();
        ground.Run(4);
        Assert.InRange(ground.Count<Heartbeat>(), 19, 21);
    }

    [Fact]
    public void Interval_OfAnUnknownMessage_IsDeniedWithText()
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Denied, ground.Stream(436, 2));
        ground.Run(0.2);
        Assert.Contains("No ap_message for mavlink id (436)", ground.Texts);
    }

    [Fact]
    public void GroundStation_OnItsOwnLink_ItsHeartbeatsArePassedOn()
    {
        using var ground = new Ground(new SimulationOptions { HasGroundStation = true });
        ground.Run(5.5);
        Assert.InRange(ground.Frames.Count(f => f.Frame.SystemId == 255 && f.Frame.ComponentId == 190), 5, 6);
    }

    [Fact]
    public void OtherCommander_WithAPlace_IsFollowedWithoutAChangeOfTheMode()
    {
        using Ground ground = Fly(new ScriptedFault
        {
            Kind = ScriptedFaultKind.OtherCommander,
            Place = new NedPosition(0, 60, -20),
        });
        ground.Stream(PositionTargetLocalNed.MavlinkId, 4);
        ground.GoTo(80, 0, 20);
        FailsafeTests.RunTo(ground, At - 0.1);
        Assert.InRange(ground.Last<PositionTargetLocalNed>().X, 77, 83);
        int acknowledged = ground.Count<CommandAck>();
        FailsafeTests.RunTo(ground, At + 0.5);
        Assert.InRange(ground.Last<PositionTargetLocalNed>().Y, 57, 63);
        Assert.Equal(acknowledged, ground.Count<CommandAck>());
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        ground.Run(30);
        Assert.True(FlightTests.Distance(ground, 0, 60) < 5);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void OtherCommander_Streaming_LeadsOrStopsTheVehicle(bool hasPlace)
    {
        using Ground ground = Fly(new ScriptedFault
        {
            Kind = ScriptedFaultKind.OtherCommander,
            Duration = TimeSpan.FromSeconds(20),
            Place = hasPlace ? new NedPosition(0, 40, -20) : null,
        });
        FailsafeTests.RunTo(ground, At - 2);
        ground.GoTo(80, 0, 20);
        FailsafeTests.RunTo(ground, At + 19);
        Assert.Equal(hasPlace, FlightTests.Distance(ground, 0, 40) < 5);
        Assert.True(ground.Truth.Pose.Position.North < 30);
    }

    [Fact]
    public void Targets_InEachMode_AreReportedAsByTheRealOne()
    {
        using var ground = new Ground(new SimulationOptions { Seed = 4 });
        ground.Stream(PositionTargetLocalNed.MavlinkId, 10);
        ground.Stream(PositionTargetGlobalInt.MavlinkId, 10);
        ground.Stream(GpsGlobalOrigin.MavlinkId, 10);
        ground.TakeOff(15);
        ground.GoTo(60, 30, 15);
        ground.Run(0.5);
        PositionTargetLocalNed local = ground.Last<PositionTargetLocalNed>();
        PositionTargetGlobalInt wrong = ground.Last<PositionTargetGlobalInt>();
        GpsGlobalOrigin origin = ground.Last<GpsGlobalOrigin>();
        Assert.Equal((PositionTargetTypemask)3576, local.TypeMask);
        Assert.InRange(local.X, 56, 64);
        Assert.InRange(local.Y, 26, 34);

        // The offset from the origin divided by 100, in height too.
        Assert.Equal((PositionTargetTypemask)0xFDF8, wrong.TypeMask);
        Assert.InRange((wrong.LatInt - origin.Latitude) * 0.0111, 0.5, 0.7);
        Assert.InRange(wrong.Alt - (origin.Altitude / 1000.0), 0.1, 0.2);

        ground.Fly(2, 0, 0);
        ground.Forget();
        ground.Run(0.5);
        Assert.Equal((PositionTargetTypemask)3079, ground.Last<PositionTargetLocalNed>().TypeMask);
        Assert.Equal(2, ground.Last<PositionTargetLocalNed>().Vx);
        Assert.Equal(0, ground.Count<PositionTargetGlobalInt>());
        ground.SetMode(CopterMode.Loiter);
        ground.Forget();
        ground.Run(0.5);
        Assert.Equal(0, ground.Count<PositionTargetLocalNed>() + ground.Count<PositionTargetGlobalInt>());
        ground.SetMode(CopterMode.Rtl);
        ground.Run(0.5);
        Assert.InRange(ground.Last<PositionTargetGlobalInt>().Alt - (origin.Altitude / 1000.0), 13, 17);
    }

    [Fact]
    public void Brake_FromAFlight_StopsAndStays()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(15);
        ground.GoTo(100, 0, 15);
        ground.Command(MavCmd.DoChangeSpeed, 1, 6, -1);
        ground.Run(8);
        double from = ground.Truth.Pose.Position.North;
        ground.SetMode(CopterMode.Brake);
        ground.Run(6);
        Assert.InRange(ground.Truth.Pose.Position.North - from, 4, 12);
        ground.GoTo(100, 0, 15);
        ground.Run(3);
        Assert.True(Math.Abs(ground.Truth.Pose.VelocityNed.North) < 0.2);
    }

    [Theory]
    [InlineData(false, "RTL_ALT", 2500)]
    [InlineData(true, "RTL_ALT_M", 25)]
    public void ReturnHeight_ByEitherName_IsFlown(bool hasNewerNames, string name, double value)
    {
        using var ground = new Ground(new SimulationOptions
        {
            WindMetresPerSecond = 0,
            HasNewerParameterNames = hasNewerNames,
            Parameters = FailsafeTests.Parameters([(name, value)]),
        });
        ground.TakeOff(10);
        ground.GoTo(60, 0, 10);
        ground.Run(20);
        ground.SetMode(CopterMode.Rtl);
        ground.RunUntil(() => FlightTests.Distance(ground, 60, 0) > 10, 40, "on the way");
        Assert.InRange(-ground.Truth.Pose.Position.Down, 22, 28);
    }

    [Fact]
    public void Options_Invalid_NameWhatIsWrong()
    {
        var options = new SimulationOptions
        {
            Parameters = FailsafeTests.Parameters([("RTL_ALT_M", 20), ("FS_OPTIONS", double.NaN)]),
            Faults =
            [
                new ScriptedFault { Kind = ScriptedFaultKind.GroundStationSilent },
                new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, Mode = "AUTO.LOITER" },
                new ScriptedFault { Kind = ScriptedFaultKind.Reboot, Value = 2 },
            ],
        };
        string text = Assert.Throws<ArgumentException>(() => new SimulatedWorld(options)).Message;
        foreach (string part in new[] { "RTL_ALT_M", "FS_OPTIONS", "HasGroundStation", "AUTO.LOITER", "Reboot" })
            Assert.Contains(part, text, StringComparison.Ordinal);
    }

    private static Ground Fly(params ScriptedFault[] faults)
    {
        for (int index = 0; index < faults.Length; index++)
            faults[index].At = TimeSpan.FromSeconds(At);
        var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0, Faults = faults });
        ground.TakeOff(20);
        return ground;
    }

    private static void Switch(Ground ground, ushort pulse, byte system = 255)
    {
        ground.Send(new RcChannelsOverride { TargetSystem = 1, TargetComponent = 1, Chan5Raw = pulse }, system);
        ground.Run(0.3);
    }
}
