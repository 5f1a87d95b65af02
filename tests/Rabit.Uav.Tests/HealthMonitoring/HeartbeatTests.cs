using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>Our heartbeat: once a second, and only while it is true.</summary>
public class HeartbeatTests
{
    [Fact]
    public void Heartbeat_TenMinutes_ComesOnceASecondWithoutDrift()
    {
        using var rig = new HealthRig(new WorkingManager("worker"));
        rig.PostAddress();
        rig.Fly(600);

        Assert.InRange(rig.BeatTimes.Count, 599, 601);
        Assert.All(rig.BeatTimes.Select((time, i) => time - i), late => Assert.InRange(late, 0, 0.0001));
        Assert.Equal(rig.BeatTimes.Count, rig.Report.HeartbeatsSent);
    }

    [Fact]
    public void Heartbeat_UnitsOfWorkTakeTime_DoesNotDriftEither()
    {
        var time = new VirtualTime(1);
        time.SetUnitOfWorkDuration(HealthManager.ManagerName, TimeSpan.FromMilliseconds(37));
        using var rig = new HealthRig(time);
        rig.PostAddress();
        rig.Fly(600);

        Assert.InRange(rig.BeatTimes.Count, 599, 601);
        Assert.InRange(rig.BeatTimes[rig.BeatTimes.Count - 1], 598, 600.3);
    }

    [Fact]
    public void Heartbeat_Content_IsThatOfAnOnboardController()
    {
        using var rig = new HealthRig();
        rig.PostAddress(system: 42);
        rig.Fly(2);

        MavlinkFrame frame = rig.Sink.Frames[rig.Sink.Frames.Count - 1].Frame;
        Heartbeat heartbeat = OutgoingSink.Decode<Heartbeat>(frame);
        Assert.Equal((42, 191), (frame.SystemId, frame.ComponentId));
        Assert.Equal((MavType.OnboardController, MavAutopilot.Invalid), (heartbeat.Type, heartbeat.Autopilot));
        Assert.Equal(MavState.Active, heartbeat.SystemStatus);
        Assert.Equal(
            ((MavModeFlag)0, 0u, (byte)3), (heartbeat.BaseMode, heartbeat.CustomMode, heartbeat.MavlinkVersion));
    }

    [Fact]
    public void Heartbeat_LevelIsCritical_SaysSo()
    {
        using var rig = new HealthRig();
        rig.PostAddress();
        rig.PostLink();
        rig.PostVehicle(state: MavState.Emergency);
        rig.Run(1.5);

        Assert.Equal(HealthLevel.Critical, rig.Report.Level);
        Assert.All(rig.Sink.MessagesOf<Heartbeat>(), h => Assert.Equal(MavState.Critical, h.SystemStatus));
        Assert.NotEmpty(rig.BeatTimes);
        Assert.True(rig.Report.SendsHeartbeat);
    }

    [Fact]
    public void Heartbeat_AddressNotKnown_IsSilent()
    {
        using var rig = new HealthRig();
        rig.Fly(5);
        Assert.Empty(rig.BeatTimes);
        Assert.False(rig.Report.SendsHeartbeat);

        rig.PostAddress();
        rig.Fly(3);
        Assert.Equal(3, rig.BeatTimes.Count);
    }

    [Fact]
    public void Heartbeat_ManagerStuck_IsSilentWithinTwoSecondsAndResumes()
    {
        // Begins a unit of work at 0, 3.1, 6.2, ... s and is in it for 3 s: more than the 0.1 s + 1 s that it may stay
        // away.
        var time = new VirtualTime(1);
        time.SetUnitOfWorkDuration("slow", TimeSpan.FromSeconds(3));
        using var rig = new HealthRig(time, new WorkingManager("slow"));
        rig.PostAddress();
        rig.Fly(10);

        Assert.Equal([0, 1, 4, 7, 10], rig.BeatTimes.Select(t => (int)Math.Round(t)));
        rig.Run(1.5);
        Assert.Equal(HealthReasons.ManagerStuck, rig.Report.Reasons & HealthReasons.ManagerStuck);
        Assert.Contains("manager slow is stuck", rig.Report.Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void Heartbeat_ManagerFaultsAndCarriesOn_IsSilentWithinTwoSecondsAndResumes()
    {
        var faulty = new WorkingManager("faulty", work: now =>
        {
            if (now > TimeSpan.FromSeconds(10) && now < TimeSpan.FromSeconds(20))
                throw new InvalidOperationException("broken");
        })
        {
            FaultPolicy = FaultPolicy.CarryOn,
        };
        using var rig = new HealthRig(faulty);
        rig.PostAddress();
        rig.Fly(15);

        Assert.False(rig.Report.SendsHeartbeat);
        Assert.Equal(HealthReasons.ManagerFaulted, rig.Report.Reasons);
        Assert.Contains("manager faulty faulted", rig.Report.Text!, StringComparison.Ordinal);
        Assert.InRange(rig.BeatTimes.Max(), 10, 12);

        rig.Fly(15);
        Assert.True(rig.Report.SendsHeartbeat);
        Assert.Equal(HealthLevel.Good, rig.Report.Level);
        Assert.InRange(rig.BeatTimes.First(t => t > 12), 24, 27);
    }

    [Fact]
    public void Heartbeat_SingleFault_IsSilentForAWhile()
    {
        bool hasThrown = false;
        var faulty = new WorkingManager("faulty", work: now =>
        {
            if (now > TimeSpan.FromSeconds(10.05) && !hasThrown)
            {
                hasThrown = true;
                throw new InvalidOperationException("once");
            }
        })
        {
            FaultPolicy = FaultPolicy.CarryOn,
        };
        using var rig = new HealthRig(faulty);
        rig.PostAddress();
        rig.Fly(20);

        Assert.DoesNotContain(rig.BeatTimes, t => t is > 10.5 and < 15);
        Assert.Contains(rig.BeatTimes, t => t > 15);
    }

    [Fact]
    public void Heartbeat_OwnUnitOfWorkLate_DoesNotGoOut()
    {
        var time = new VirtualTime(1);
        time.SetUnitOfWorkDuration(HealthManager.ManagerName, TimeSpan.FromSeconds(4));
        using var rig = new HealthRig(time);
        rig.PostAddress();
        rig.Fly(60);

        // The first came before we could know that we are slow.
        Assert.True(rig.BeatTimes.Count <= 1, $"{rig.BeatTimes.Count}");
    }

    [Fact]
    public void Heartbeat_RealThreadsAndAManagerThatHangs_IsSilentAndResumes()
    {
        using var release = new System.Threading.ManualResetEventSlim();
        using var silent = new System.Threading.ManualResetEventSlim();
        using var sent = new System.Threading.ManualResetEventSlim();
        bool hangs = false;
        var hanging = new WorkingManager("hanging", work: _ =>
        {
            if (System.Threading.Volatile.Read(ref hangs))
                release.Wait(TestTimeout.Limit + TestTimeout.Limit);
        });
        var sink = new OutgoingSink();
        var watcher = new ReportWatcher(report =>
        {
            if (report.SendsHeartbeat && report.HeartbeatsSent > 0)
                sent.Set();
            if (report.HeartbeatsSent > 0 && !report.SendsHeartbeat)
                silent.Set();
        });
        var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false })
        {
            sink, hanging, watcher, new HealthManager(new HealthOptions(), [hanging.Name], linkCount: 0),
        };
        reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        reactor.Workspace.Publish<MissionStatus>(MessageNames.Mission);
        reactor.Workspace.Publish<AutopilotStatistics>(MessageNames.AutopilotStatistics);
        reactor.Workspace.Publish<ImagingStatus>(MessageNames.Imaging);
        reactor.Workspace.Publish<NavigationStatus>(MessageNames.Navigation);
        MessagePublisher<OwnAddress> address = reactor.Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
        reactor.Start();
        address.Value = new OwnAddress { SystemId = 1, ComponentId = 191 };
        address.Post();

        // The machine may be busy; the two seconds are shown in virtual time.
        Assert.True(sent.Wait(TestTimeout.Limit), "no heartbeat");
        System.Threading.Volatile.Write(ref hangs, true);
        Assert.True(silent.Wait(TestTimeout.Limit), "still a heartbeat");
        System.Threading.Volatile.Write(ref hangs, false);
        sent.Reset();
        release.Set();
        Assert.True(sent.Wait(TestTimeout.Limit), "no heartbeat again");

        reactor.Stop();
        Assert.Equal(0, reactor.Finish().ExitCode);
    }

    private sealed class ReportWatcher : RabitManager
    {
        private readonly MessageSubscriber<HealthReport> _report;
        private readonly Action<HealthReport> _check;

        public ReportWatcher(Action<HealthReport> check)
            : base("watcher")
        {
            _report = Subscribe<HealthReport>(MessageNames.Health, wakeOnPost: true);
            _check = check;
        }

        protected override void ExecuteUnitOfWork()
        {
            if (_report.Fetch())
                _check(_report.Value);
        }
    }
}
