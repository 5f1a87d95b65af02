using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class AutopilotManagerTests
{
    [Fact]
    public void VehicleState_BeforeAnyHeartbeat_IsUnknown()
    {
        using var rig = new AutopilotRig();
        rig.Send(new Attitude { Roll = 1 });
        rig.Run(1);

        Assert.Equal(0, rig.VehiclePosts);
        Assert.Equal((false, (byte)0), (rig.Vehicle.IsConnected, rig.Vehicle.SystemId));
        Assert.True(double.IsNaN(rig.Vehicle.BatteryRemaining));
        Assert.False(rig.OwnAddress.IsKnown);
        Assert.Equal(1, rig.Statistics.FramesOfOthers);
    }

    [Fact]
    public void VehicleState_FirstHeartbeat_SaysWhoAndHow()
    {
        using var rig = new AutopilotRig();
        rig.Send(AutopilotRig.Copter(CopterMode.Guided, AutopilotRig.Armed, MavState.Active), system: 7, component: 1);
        rig.Run();

        VehicleState vehicle = rig.Vehicle;
        Assert.Equal((true, (byte)7, (byte)1), (vehicle.IsConnected, vehicle.SystemId, vehicle.ComponentId));
        Assert.Equal((MavAutopilot.Ardupilotmega, MavType.Quadrotor), (vehicle.Autopilot, vehicle.VehicleType));
        Assert.Equal(
            ("GUIDED", 4u, true, MavState.Active),
            (vehicle.Mode, vehicle.CustomMode, vehicle.IsArmed, vehicle.SystemStatus));
        Assert.Equal((7, 191), (rig.OwnAddress.SystemId, rig.OwnAddress.ComponentId));
    }

    [Fact]
    public void VehicleState_SeveralFramesAtOnce_IsPostedOnceWithTheNewestTime()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        int posts = rig.VehiclePosts;
        rig.Send(new Attitude { Roll = 0.1f }, time: TimeSpan.FromMilliseconds(900));
        rig.Send(new Attitude { Roll = 0.2f }, time: TimeSpan.FromMilliseconds(950));
        rig.Send(new VfrHud(), time: TimeSpan.FromMilliseconds(980));
        rig.Run();

        Assert.Equal(posts + 1, rig.VehiclePosts);
        Assert.Equal(TimeSpan.FromMilliseconds(950), rig.VehicleTime);
        Assert.Equal(0.2f, rig.Vehicle.Attitude.Roll.Radians);
    }

    [Fact]
    public void VehicleState_FramesWithoutNews_IsNotPosted()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        int posts = rig.VehiclePosts;
        rig.Send(new VfrHud());
        rig.Send(new Attitude { Roll = float.NaN });
        rig.Run(1);

        Assert.Equal(posts, rig.VehiclePosts);
        Assert.Equal(1, rig.Statistics.RefusedMessages);
    }

    [Fact]
    public void IsConnected_HeartbeatsStop_IsLostAfterTheTimeout()
    {
        using var rig = new AutopilotRig();
        rig.Beat(3);   // at 0, 1 and 2 s
        rig.Run(3.9);
        Assert.True(rig.Vehicle.IsConnected);
        rig.Run(0.6);

        Assert.False(rig.Vehicle.IsConnected);
        Assert.Equal(TimeSpan.FromSeconds(7), rig.VehicleTime);
        Assert.Equal(1, rig.Statistics.Losses);
        Assert.Equal("STABILIZE", rig.Vehicle.Mode);
    }

    [Fact]
    public void IsConnected_OtherTelemetryGoesOn_IsLostAllTheSame()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        for (int i = 0; i < 60; i++)
        {
            rig.Send(new Attitude());
            rig.Run(0.1);
        }

        Assert.False(rig.Vehicle.IsConnected);
    }

    [Fact]
    public void IsConnected_HeartbeatComesAgain_IsBack()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        rig.Run(10);
        Assert.False(rig.Vehicle.IsConnected);
        rig.Beat(1);

        Assert.True(rig.Vehicle.IsConnected);
        Assert.Equal(1, rig.Statistics.Losses);
    }

    [Theory]
    [InlineData(60, 0)]
    [InlineData(20, 1)]
    public void IsConnected_UnitsOfWorkThatTakeEightSeconds_AreNoLoss(int heartbeats, int losses)
    {
        var time = new VirtualTime(1);
        time.SetUnitOfWorkDuration(AutopilotManager.ManagerName, TimeSpan.FromSeconds(8));
        var manager = new AutopilotManager(new AutopilotOptions { RequestsRates = false });
        var reactor = new RabitReactor(time) { manager, new OutgoingSink(), new AutopilotPeers() };
        QueueSender<LinkFrame> frames = reactor.Workspace.Send<LinkFrame>(MessageNames.AutopilotFrames);
        MessageSubscriber<AutopilotStatistics> statistics = reactor.Workspace.Subscribe<AutopilotStatistics>(
            MessageNames.AutopilotStatistics);
        reactor.Start();
        for (int second = 0; second < 60; second++)
        {
            if (second < heartbeats)
                frames.Push(AutopilotRig.FrameOf(AutopilotRig.Copter(), reactor.Now));
            reactor.RunFor(TimeSpan.FromSeconds(1));
        }

        reactor.Stop();
        reactor.Finish();
        statistics.Fetch();
        Assert.Equal(losses, statistics.Value.Losses);
    }

    [Fact]
    public void IsConnected_FramesHandedOverOnlyAfterAStall_AreNotMissed()
    {
        // The manager is away until 8 s, wakes at 8.2 s to an empty queue, and what came meanwhile is handed over at
        // 8.3 s.
        var time = new VirtualTime(1);
        time.SetUnitOfWorkDuration(AutopilotManager.ManagerName, TimeSpan.FromSeconds(8));
        var manager = new AutopilotManager(new AutopilotOptions { RequestsRates = false });
        var reactor = new RabitReactor(time) { manager, new OutgoingSink(), new AutopilotPeers() };
        QueueSender<LinkFrame> frames = reactor.Workspace.Send<LinkFrame>(MessageNames.AutopilotFrames);
        MessageSubscriber<AutopilotStatistics> statistics = reactor.Workspace.Subscribe<AutopilotStatistics>(
            MessageNames.AutopilotStatistics);
        reactor.Start();
        frames.Push(AutopilotRig.FrameOf(AutopilotRig.Copter(), TimeSpan.Zero));
        reactor.RunFor(TimeSpan.FromSeconds(8.3));
        for (int second = 1; second <= 8; second++)
            frames.Push(AutopilotRig.FrameOf(AutopilotRig.Copter(), TimeSpan.FromSeconds(second)));
        reactor.RunFor(TimeSpan.FromSeconds(8.2));

        statistics.Fetch();
        Assert.Equal((9L, 0L), (statistics.Value.Frames, statistics.Value.Losses));
        reactor.Stop();
        reactor.Finish();
    }

    [Fact]
    public void IsConnected_GapInsideOneBatch_CountsAsLossWhenEverItIsHandled()
    {
        using var rig = new AutopilotRig();
        rig.Run(100);
        rig.Send(AutopilotRig.Copter(), time: TimeSpan.FromSeconds(90));
        rig.Send(AutopilotRig.Copter(), time: TimeSpan.FromSeconds(96));
        rig.Send(AutopilotRig.Copter(), time: TimeSpan.FromSeconds(99));
        rig.Run();

        Assert.True(rig.Vehicle.IsConnected);
        Assert.Equal(1, rig.Statistics.Losses);
    }

    [Fact]
    public void Heartbeats_OfGroundStationAndOurselves_ChangeNothing()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        int posts = rig.VehiclePosts;
        rig.Send(new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid }, system: 255, component: 190);
        rig.Send(new Heartbeat { Type = MavType.OnboardController, Autopilot = MavAutopilot.Invalid }, component: 191);
        rig.Run();

        Assert.Equal(posts, rig.VehiclePosts);
        Assert.Equal(2, rig.Statistics.FramesOfOthers);
        Assert.Equal(0, rig.Statistics.HeartbeatsOfOtherAutopilots);
    }

    [Fact]
    public void Autopilots_ASecondOne_IsNotOurs()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        rig.Send(AutopilotRig.Copter(CopterMode.Rtl), system: 2);
        rig.Send(new GlobalPositionInt { Lat = 1, Lon = 1 }, system: 2);
        rig.Run(20);
        rig.Send(AutopilotRig.Copter(CopterMode.Rtl), system: 2);
        rig.Run();

        Assert.Equal((1, "STABILIZE", false), (rig.Vehicle.SystemId, rig.Vehicle.Mode, rig.Vehicle.IsConnected));
        Assert.Null(rig.Vehicle.PositionTime);
        Assert.Equal((3L, 2L), (rig.Statistics.FramesOfOthers, rig.Statistics.HeartbeatsOfOtherAutopilots));
        Assert.Equal(1, rig.OwnAddress.SystemId);
    }

    [Fact]
    public void Autopilots_ConfiguredSystem_OnlyThatOneIsOurs()
    {
        using var rig = new AutopilotRig(
            new AutopilotOptions { SystemId = 9, ComponentId = 192, RequestsRates = false });
        Assert.Equal((9, 192), (rig.OwnAddress.SystemId, rig.OwnAddress.ComponentId));
        rig.Beat(2);
        Assert.Equal(0, rig.VehiclePosts);
        rig.Send(AutopilotRig.Copter(), system: 9);
        rig.Run();

        Assert.Equal((9, true), (rig.Vehicle.SystemId, rig.Vehicle.IsConnected));
    }

    [Fact]
    public void StatusTexts_OfTheVehicle_AreKeptNewestFirst()
    {
        using var rig = new AutopilotRig();
        rig.Send(Text("too early"), time: TimeSpan.Zero);
        rig.Beat(1);
        for (int i = 0; i < 25; i++)
            rig.Send(Text($"text {i}"), component: (byte)(i % 2 == 0 ? 1 : 154));
        rig.Send(Text("of another"), system: 2);
        rig.Run();

        Assert.Equal(AutopilotManager.RecentItemsKept, rig.Texts.Count);
        Assert.Equal(Enumerable.Range(5, 20).Select(i => $"text {24 + 5 - i}"), rig.Texts.Select(t => t.Text));
        Assert.Equal(
            (MavSeverity.Warning, TimeSpan.FromSeconds(1)), (rig.Texts.Newest!.Severity, rig.Texts.Newest.Time));
    }

    [Fact]
    public void CommandAcknowledgements_OfTheAutopilot_AreKeptNewestFirst()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        rig.Send(
            new CommandAck
            {
                Command = MavCmd.ComponentArmDisarm,
                Result = MavResult.Failed,
                TargetSystem = 1,
                TargetComponent = 191
            });
        rig.Send(new CommandAck { Command = MavCmd.NavTakeoff, Result = MavResult.Accepted });
        rig.Send(new CommandAck { Command = MavCmd.NavLand }, component: 100);
        rig.Run();

        Assert.Equal([MavCmd.NavTakeoff, MavCmd.ComponentArmDisarm], rig.Acknowledgements.Select(a => a.Command));
        CommandAcknowledgement oldest = rig.Acknowledgements.Last();
        Assert.Equal((MavResult.Failed, 1, 191), (oldest.Result, oldest.TargetSystem, oldest.TargetComponent));
    }

    [Fact]
    public void ExecuteUnitOfWork_SteadyState_AllocatesNothing()
    {
        using var rig = new AutopilotRig();
        rig.Peers.KeepsPoses = false;
        void OneSecond()
        {
            rig.Send(AutopilotRig.Copter(flags: AutopilotRig.Armed));
            for (int i = 0; i < 50; i++)
            {
                rig.Send(new Attitude { Roll = 0.1f });
                rig.Send(new GlobalPositionInt { Lat = 1, Lon = 1 });
                rig.Run(0.02);
            }
        }

        OneSecond();
        OneSecond();
        Assert.Equal(0, Allocated.By(OneSecond));
    }

    private static Statustext Text(string text) => new() { Severity = MavSeverity.Warning, Text = new Text50(text) };
}
