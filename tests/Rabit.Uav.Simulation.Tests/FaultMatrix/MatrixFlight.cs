using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>
/// One flight of the fault matrix: flown to its end, or for a time after the vehicle was handed over.
/// </summary>
internal sealed class MatrixFlight : IDisposable
{
    private static readonly TimeSpan Step = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan MaxTime = TimeSpan.FromMinutes(20);
    private static readonly TimeSpan AfterTheEnd = TimeSpan.FromSeconds(5);

    private readonly FaultCell? _cell;
    private readonly TimeSpan _at;
    private readonly TimeSpan? _holdAt;

    /// <param name="cell">What is flown; null: nothing goes wrong.</param>
    /// <param name="model">With which autopilot.</param>
    /// <param name="seed">Of the world and of the order of events.</param>
    /// <param name="at">When it goes wrong.</param>
    /// <param name="holdAt">When the operator commands a hold; null: never.</param>
    /// <param name="latency">Of the link; null: as in other tests.</param>
    /// <param name="faults">More that goes wrong.</param>
    public MatrixFlight(
        FaultCell? cell, SimulatedAutopilot model, long seed, TimeSpan at, TimeSpan? holdAt = null,
        TimeSpan? latency = null, params ScriptedFault[] faults)
    {
        (_cell, _at, _holdAt) = (cell, at, holdAt);
        ScriptedFault[] script = [.. cell?.Fault.Script(model, at) ?? [], .. faults];
        RabitManager[] others = cell?.Fault.Throws == true
            ? [new PayloadManager(throwsAt: at) { FaultPolicy = FaultPolicy.CarryOn }]
            : [];
        SimulationOptions options = MatrixWorld.Options(model, seed, script);
        options.TelemetryLatency = latency ?? options.TelemetryLatency;
        LinkTap? tap = null;
        Flight = new SearchFlight(
            MatrixWorld.Mission(), options, new VirtualTime(seed), others,
            around: link => tap = new LinkTap(link, () => Flight!.Reactor.Now));
        Tap = tap!;
    }

    public SearchFlight Flight { get; }

    public LinkTap Tap { get; }

    /// <summary>The phase when it went wrong.</summary>
    public MissionPhase PhaseAtFault { get; private set; }

    /// <summary>The mode at the moment of the takeover, when it was reported; empty where there was none.</summary>
    public string ModeTaken { get; private set; } = string.Empty;

    /// <summary>Modes that the vehicle truly had after the takeover, while it was armed.</summary>
    public HashSet<string> ModesAfter { get; } = new(StringComparer.Ordinal);

    public CommandAuthority Authority { get; private set; }

    public MissionStatus Mission { get; private set; }

    public SimulatedTruth Truth { get; private set; } = null!;

    /// <summary>Whether the flight had no end within the longest time.</summary>
    public bool Hangs { get; private set; }

    private TimeSpan Now => Flight.Reactor.Now;

    /// <summary>Flies until it is decided how it ends.</summary>
    public void Fly(TimeSpan watch)
    {
        FlyToTheFault();
        bool isStopped = _cell?.Fault.StopsProgram == true;
        if (!isStopped)
            FlyToTheEnd(watch);
        Flight.End();
        Observe();
        Flight.Dispose();
    }

    /// <summary>Flies on for a time; what is seen of it is noted.</summary>
    public void FlyUntil(TimeSpan time)
    {
        if (!Flight.Reactor.IsWired)
            Flight.Reactor.Start();
        while (Now < time)
        {
            TimeSpan left = time - Now;
            Flight.Reactor.RunFor(left < Step ? left : Step);
            Observe();
        }
    }

    public void Dispose() => Flight.Dispose();

    private void FlyToTheFault()
    {
        if (_holdAt is { } holdAt)
        {
            FlyUntil(holdAt);
            Flight.Control.Hold("test", "the matrix");
        }

        FlyUntil(_at - TimeSpan.FromMilliseconds(10));
        PhaseAtFault = Mission.Phase;
        _cell?.Fault.Action?.Invoke(this);
        FlyUntil(_at);
    }

    private void FlyToTheEnd(TimeSpan watch)
    {
        TimeSpan? resumeAt = _holdAt is null ? null : _at + NominalTimeline.HoldTime;
        TimeSpan? endsAt = null;
        while (endsAt is not { } end || Now < end)
        {
            FlyUntil(Now + Step);
            if (resumeAt <= Now)
            {
                resumeAt = null;
                if (Mission.Phase == MissionPhase.Holding)
                    Flight.Control.ContinueMission("test", "the matrix");
            }

            Hangs = Now > MaxTime;
            if (Hangs)
                return;
            endsAt ??= Mission.Phase switch
            {
                MissionPhase.Done or MissionPhase.Failed => Now + AfterTheEnd,
                MissionPhase.HandedOver => Now + watch,
                _ => null,
            };
        }
    }

    private void Observe()
    {
        (Mission, Authority, Truth) = (Flight.Mission, Flight.Authority, Flight.World.Truth);
        if (Mission.Phase != MissionPhase.HandedOver)
            return;
        if (ModeTaken.Length == 0)
            ModeTaken = Truth.Mode;
        if (Truth.IsArmed)
            ModesAfter.Add(Truth.Mode);
    }

    /// <summary>What was sent after the command was taken away.</summary>
    public IEnumerable<SentCommand> SentAfterTakeover()
        => Authority.State == CommandAuthorityState.TakenAway
            ? Tap.Sent.Where(s => s.Time > Authority.Since)
            : [];
}
