using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Mission Control in virtual time with a stand-in for all other managers.</summary>
internal sealed class MissionRig : IDisposable
{
    public static readonly GeodeticPosition Home = GeodeticPosition.FromDegrees(47.3977, 8.5456, 488);

    private static readonly TimeSpan MaxStopDelay = TimeSpan.FromSeconds(4);

    private readonly RabitReactor _reactor;
    private readonly MessageSubscriber<MissionStatus> _status;

    public MissionRig(
        MissionPlan? mission, Action<MissionControlOptions>? change = null, long seed = 1,
        GeodeticPosition? home = null, Action<RabitReactor>? beforeStart = null)
    {
        Vehicle = new StandInVehicle(home ?? Home);
        var options = new MissionControlOptions { Mission = mission };
        change?.Invoke(options);
        Manager = new MissionControlManager(options);
        _reactor = new RabitReactor(
            new ReactorOptions
            {
                Time = new VirtualTime(seed),
                Log = Entries.Add,
                StopsOnSignals = false,
                MaxStopDelay = MaxStopDelay,
            })
        {
            Manager, Vehicle
        };
        _status = _reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        beforeStart?.Invoke(_reactor);
        _reactor.Start();
    }

    /// <summary>A mission with one target that has got to a phase.</summary>
    public static MissionRig In(MissionPhase phase, Action<MissionControlOptions>? change = null)
    {
        var rig = new MissionRig(Mission(), change);
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        if (phase == MissionPhase.WaitingForVehicle)
            rig.Run(1);
        if (phase == MissionPhase.Arming)
            rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Arm ? VehicleCommandOutcome.Refused : null;
        Assert.Equal(phase, rig.RunUntil(phase));
        if (phase == MissionPhase.TakingOff)
            rig.Run(2);
        return rig;
    }

    public MissionControlManager Manager { get; }

    public StandInVehicle Vehicle { get; }

    public List<RabitLogEntry> Entries { get; } = [];

    /// <summary>What Mission Control logged.</summary>
    public IEnumerable<string> Decisions => Entries
        .Where(e => e.Source == MissionControlManager.ManagerName && e.Kind == RabitLogKind.Manager)
            .Select(e => e.ToString());

    public string Story => string.Join(Environment.NewLine, Decisions);

    public MissionStatus Status
    {
        get
        {
            _status.Fetch();
            return _status.Value;
        }
    }

    public int StatusPosts
    {
        get
        {
            _status.Fetch();
            return _status.Stamp.Version;
        }
    }

    public TimeSpan Now => _reactor.Now;

    /// <summary>A mission over a field north of home.</summary>
    public static MissionPlan Mission(string more = "", string area = "[[60,-60],[60,60],[150,60],[150,-60]]")
        => MissionPlan.Parse(Text(more, area), "test");

    /// <summary>As text; the area in metres from home.</summary>
    public static string Text(string more = "", string area = "[[60,-60],[60,60],[150,60],[150,-60]]")
    {
        var frame = LocalNedFrame.IgnoringGeoid(Home);
        using var corners = System.Text.Json.JsonDocument.Parse(area);
        IEnumerable<string> places = corners.RootElement.EnumerateArray().Select(c =>
        {
            GeodeticPosition p = frame.ToGeodetic(new NedPosition(c[0].GetDouble(), c[1].GetDouble(), 0));
            return string.Format(
                CultureInfo.InvariantCulture, "[{0:R},{1:R}]", p.Latitude.Degrees, p.Longitude.Degrees);
        });
        return "{\"area\":[" + string.Join(",", places)
            + "],\"heightMetres\":40,\"speedMetresPerSecond\":8,\"laneSpacingMetres\":30" + more + "}";
    }

    /// <summary>Asks for the stop, and runs until it is over.</summary>
    /// <returns>How long it took.</returns>
    public TimeSpan Stop()
    {
        TimeSpan from = Now;
        _reactor.Stop("the test");
        while (Now - from < TimeSpan.FromSeconds(20) && _reactor.RunFor(TimeSpan.FromSeconds(0.05)))
        {
        }

        return Now - from;
    }

    public void Run(double seconds) => _reactor.RunFor(TimeSpan.FromSeconds(seconds));

    /// <summary>Runs until a phase, or for a maximum time.</summary>
    public MissionPhase RunUntil(MissionPhase phase, double maxSeconds = 900)
    {
        for (double t = 0; t < maxSeconds && Status.Phase != phase; t += 0.1)
            Run(0.1);
        return Status.Phase;
    }

    /// <summary>Runs until the mission is over, or for a maximum time.</summary>
    public MissionPhase RunToEnd(double maxSeconds = 1500)
    {
        for (double t = 0;
            t < maxSeconds && Status.Phase is not (MissionPhase.Done or MissionPhase.HandedOver or MissionPhase.Failed);
            t++)
            Run(1);
        return Status.Phase;
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
    }
}
