using System;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

public class HealthManagerTests
{
    [Fact]
    public void Report_AllWell_IsGoodWithoutText()
    {
        using var rig = new HealthRig(new WorkingManager("a"), new WorkingManager("b", wakeUpSeconds: 1));
        rig.PostAddress();
        rig.Fly(30);

        HealthReport report = rig.Report;
        Assert.Equal(
            (HealthLevel.Good, HealthReasons.None, null, true),
            (report.Level, report.Reasons, report.Text, report.SendsHeartbeat));
    }

    [Fact]
    public void Report_NothingReceived_WarnsOfAutopilotAndLink()
    {
        using var rig = new HealthRig();
        rig.Run(1);
        Assert.Equal((HealthLevel.Warning, HealthReasons.NoAutopilot), (rig.Report.Level, rig.Report.Reasons));
        rig.Run(5);
        Assert.Equal(HealthReasons.NoAutopilot | HealthReasons.LinkSilent, rig.Report.Reasons);
        Assert.Equal("no autopilot detected yet; link 0: nothing received yet", rig.Report.Text);
    }

    [Fact]
    public void Report_AutopilotLost_ComesBackGood()
    {
        using var rig = new HealthRig();
        rig.Fly(3);
        rig.PostVehicle(isConnected: false);
        rig.Run(0.3);
        Assert.Equal((HealthLevel.Critical, HealthReasons.AutopilotLost), (rig.Report.Level, rig.Report.Reasons));
        rig.Fly(1);
        Assert.Equal(HealthLevel.Good, rig.Report.Level);
    }

    [Fact]
    public void Report_AutopilotInterfaceStopsPosting_StateExpires()
    {
        using var rig = new HealthRig();
        rig.Fly(3);
        rig.PostLink();
        rig.Run(6);
        Assert.Equal(HealthReasons.AutopilotLost, rig.Report.Reasons);
    }

    [Fact]
    public void Report_LogAtItsEnd_IsNoFault()
    {
        using var rig = new HealthRig();
        rig.PostVehicle();
        rig.PostLink(LinkState.Ended, progress: 1);
        rig.Run(60);
        Assert.Equal((HealthLevel.Good, HealthReasons.None), (rig.Report.Level, rig.Report.Reasons));
    }

    [Fact]
    public void Report_FramesToALinkWithoutPeer_AreNoLoss()
    {
        using var rig = new HealthRig();
        rig.Fly(2);
        rig.PostLink(LinkState.Waiting, droppedOut: 50);
        rig.Run(0.3);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons & HealthReasons.FramesDropped);

        rig.PostLink(LinkState.Receiving, droppedOut: 50);
        rig.Run(0.3);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons & HealthReasons.FramesDropped);

        rig.PostLink(LinkState.Receiving, droppedOut: 51);
        rig.Run(0.3);
        Assert.Equal(HealthReasons.FramesDropped, rig.Report.Reasons & HealthReasons.FramesDropped);
    }

    // Where the peers of a UDP link are gone, all that is sent is dropped, for as long as they are.
    [Fact]
    public void Report_FramesToALinkWhosePeersAreGone_AreNoLossAndThoseToANewPeerAre()
    {
        using var rig = new HealthRig();
        rig.Fly(2);
        for (int i = 1; i <= 12; i++)
        {
            rig.PostLink(LinkState.Silent, droppedOut: i);
            rig.PostVehicle();
            rig.Run(1);
            Assert.Equal(HealthReasons.LinkSilent, rig.Report.Reasons);
        }

        rig.PostLink(LinkState.Receiving, droppedOut: 12);
        rig.Run(0.3);
        Assert.Equal(HealthReasons.None, rig.Report.Reasons);

        rig.PostLink(LinkState.Receiving, droppedOut: 15);
        rig.Run(0.3);
        Assert.Equal(HealthReasons.FramesDropped, rig.Report.Reasons);
        Assert.Contains("3 so far", rig.Report.Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void Report_FramesDropped_IsReportedForAWhile()
    {
        using var rig = new HealthRig();
        rig.Fly(2);
        rig.PostLink(dropped: 7);
        rig.Run(0.3);
        Assert.Equal(HealthReasons.FramesDropped, rig.Report.Reasons);
        Assert.Contains("7 so far", rig.Report.Text!, StringComparison.Ordinal);
        for (int i = 0; i < 6; i++)
        {
            rig.PostVehicle();
            rig.Run(1);
        }

        Assert.Equal(HealthReasons.None, rig.Report.Reasons);
    }

    [Fact]
    public void Report_SeveralReasons_HasTheMostSevereLevel()
    {
        using var rig = new HealthRig();
        rig.PostLink(LinkState.Silent);
        rig.PostVehicle(remaining: 0.2, state: MavState.Emergency);
        rig.Run(2.5);

        Assert.Equal(HealthLevel.Critical, rig.Report.Level);
        Assert.Equal(
            HealthReasons.LinkSilent | HealthReasons.BatteryLow | HealthReasons.AutopilotCritical, rig.Report.Reasons);
        Assert.Equal(
            "autopilot reports Emergency; battery low (20 %); link udpin:0.0.0.0:14550 is silent", rig.Report.Text);
    }

    [Fact]
    public void Report_News_IsPostedWithinHalfASecondElseOnceASecond()
    {
        using var rig = new HealthRig();
        rig.Run(0.1);
        int reports = rig.Reports;
        rig.Run(10);
        Assert.InRange(rig.Reports - reports, 10, 13);
        rig.PostVehicle(state: MavState.Emergency);
        rig.Run(0.5);
        Assert.Equal(HealthReasons.AutopilotCritical, rig.Report.Reasons & HealthReasons.AutopilotCritical);
    }

    [Fact]
    public void ExecuteUnitOfWork_SteadyState_AllocatesNothing()
    {
        using var rig = new HealthRig(new WorkingManager("a"), new WorkingManager("b"));
        rig.PostAddress();
        rig.PostLink(LinkState.Silent);
        void TenSeconds()
        {
            for (int i = 0; i < 10; i++)
            {
                rig.PostVehicle(remaining: 0.2);
                rig.Run(1);
            }
        }

        rig.Sink.Frames.Capacity = 1000;
        TenSeconds();
        TenSeconds();
        Assert.Equal(0, Allocated.By(TenSeconds));
        Assert.Equal(HealthLevel.Warning, rig.Report.Level);
    }

    [Fact]
    public void ExecuteUnitOfWork_SteadyFlight_AllocatesNothing()
    {
        using var vehicle = new FlownVehicle();
        void Hold() => vehicle.Fly(10, static (ref VehicleState s, ref NavigationStatus _) => s.Satellites = 5);
        vehicle.Rig.Sink.Frames.Capacity = 1000;
        Hold();
        Hold();
        Assert.Equal(0, Allocated.By(Hold));
        Assert.Equal(HealthReasons.PositionFixPoor, vehicle.Report.Reasons);
    }

    [Fact]
    public void Constructor_BadOptions_NamesAllFaults()
    {
        var options = new HealthOptions
        {
            BatteryLowFraction = 1.5,
            BatteryCriticalFraction = double.NaN,
            AutopilotTimeout = TimeSpan.Zero,
            StuckAfter = TimeSpan.Zero,
            RecentWindow = TimeSpan.Zero,
            FirstFrameTimeout = TimeSpan.Zero,
            BatteryCells = 0,
            BatteryLowCellVolts = 5,
            BatteryCriticalCellVolts = 0,
            MinSatellites = 3,
            MaxHorizontalDilution = 0.9,
            MaxEstimatorRatio = 0.1,
            PositionErrorMetres = 2,
            HeightErrorMetres = double.NaN,
            WindHighMetresPerSecond = 0,
            WindHighAfter = TimeSpan.FromSeconds(-1),
            CameraSilentAfter = TimeSpan.Zero,
            StatusTextPeriod = TimeSpan.Zero,
        };
        string text = Assert.Throws<ArgumentException>(() => new HealthManager(options, [], 0)).Message;
        foreach (string name in new[]
        {
            "BatteryLowFraction", "BatteryCriticalFraction", "AutopilotTimeout", "StuckAfter", "RecentWindow",
            "FirstFrameTimeout", "WindHighMetresPerSecond", "WindHighAfter", "CameraSilentAfter", "StatusTextPeriod",
            "BatteryCells", "BatteryLowCellVolts", "BatteryCriticalCellVolts", "MinSatellites",
            "MaxHorizontalDilution", "MaxEstimatorRatio", "PositionErrorMetres", "HeightErrorMetres",
        })
            Assert.Contains(name, text, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new HealthManager(new HealthOptions(), ["a", "a"], 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new HealthManager(new HealthOptions(), [], -1));
    }

    [Fact]
    public void Constructor_ManagerThatIsNotThere_IsAWiringFault()
    {
        var reactor = new RabitReactor(new VirtualTime(1))
        {
            new OutgoingSink(),
            new HealthManager(new HealthOptions(), ["ghost"], 0)
        };
        Assert.Contains("ghost", Assert.Throws<RabitWiringException>(reactor.Start).Message, StringComparison.Ordinal);
    }
}
