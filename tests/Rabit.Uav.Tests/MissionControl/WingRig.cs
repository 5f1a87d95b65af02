using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Mission Control and Autopilot Interface in virtual time with a simulated fixed wing.</summary>
internal sealed class WingRig : IDisposable
{
    private readonly RabitReactor _reactor;
    private readonly MessageSubscriber<MissionStatus> _status;
    private readonly MessageSubscriber<CommandAuthority> _authority;

    public WingRig(MavAutopilot make, MissionPlan? mission = null, bool isAllowed = true)
    {
        var options = new MissionControlOptions
        {
            Mission = mission ?? Mission(),
            FixedWing = isAllowed ? new FixedWingOptions { LoiterRadiusMetres = 80 } : null,
        };
        Manager = new MissionControlManager(options);
        Wing = new SimulatedWing(make, MissionRig.Home);
        _reactor = new RabitReactor(
            new ReactorOptions { Time = new VirtualTime(1), Log = Entries.Add, StopsOnSignals = false })
        {
            Manager,
            new AutopilotManager(
                new AutopilotOptions { RequestsRates = false, MayCommand = true, MayCommandFixedWing = isAllowed }),
            Wing,
        };
        _status = _reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        _authority = _reactor.Workspace.Subscribe<CommandAuthority>(MessageNames.CommandAuthority);
        _reactor.Workspace.Receive<TrackDecision>(MessageNames.TrackDecisions);
        _reactor.Start();
    }

    public MissionControlManager Manager { get; }

    public SimulatedWing Wing { get; }

    public List<RabitLogEntry> Entries { get; } = [];

    public string Story => string.Join(Environment.NewLine, Entries.Select(e => e.ToString()));

    /// <summary>How many commands to go to a place Mission Control sent.</summary>
    public int Legs => Entries.Count(e => e.ToString().Contains(": go to ", StringComparison.Ordinal));

    public MissionStatus Status
    {
        get
        {
            _status.Fetch();
            return _status.Value;
        }
    }

    public CommandAuthority Authority
    {
        get
        {
            _authority.Fetch();
            return _authority.Value;
        }
    }

    public TimeSpan Now => _reactor.Now;

    /// <summary>A field of 400 by 120 m, at 60 m.</summary>
    public static MissionPlan Mission(Func<string, string>? change = null)
    {
        string text = MissionRig.Text(string.Empty, "[[200,-200],[200,200],[320,200],[320,-200]]")
            .Replace("\"heightMetres\":40,\"speedMetresPerSecond\":8", Figures);
        return MissionPlan.Parse(change is null ? text : change(text), "wing");
    }

    private const string Figures = "\"fenceMarginMetres\":300,\"heightMetres\":60,\"speedMetresPerSecond\":20";

    /// <summary>Taken off by its pilot and given over at the height of the search.</summary>
    public WingRig Begun()
    {
        Run(5);
        Wing.TakeOff(60);
        Run(40);
        Wing.GiveOver();
        RunUntil(MissionPhase.Searching, 10);
        return this;
    }

    public void Run(double seconds) => _reactor.RunFor(TimeSpan.FromSeconds(seconds));

    public MissionPhase RunUntil(MissionPhase phase, double maxSeconds)
    {
        for (double t = 0; t < maxSeconds && Status.Phase != phase; t += 0.1)
            Run(0.1);
        return Status.Phase;
    }

    /// <summary>Runs while something holds, which must end.</summary>
    public void RunWhile(Func<bool> holds)
    {
        for (int i = 0; i < 600 && holds(); i++)
            Run(0.5);
        Assert.False(holds(), Story);
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
    }
}
