using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation.Tests.FaultMatrix;

namespace Rabit.Uav.Simulation.Tests.TakeoverTrials;

/// <summary>
/// One trial: in a flight of the mission the pilot changes the mode, and for 20 s it is watched whether it stands.
/// </summary>
internal sealed class TakeoverTrial
{
    public static readonly TimeSpan Window = TimeSpan.FromSeconds(20);

    // PX4's, in which we never command.
    private const string NeverOurs = "POSCTL";

    // Above, AUTO.LOITER is how a take-off to 30 m ends.
    private const double EndOfTakeOffMetres = 27;

    // A mode that PX4 or ArduCopter goes on to from the pilot's own, or that his switch takes a little later.
    private static readonly TimeSpan SwitchTime = TimeSpan.FromSeconds(0.3);

    private TakeoverTrial(
        SimulatedAutopilot model, long seed, TimeSpan at, string mode, bool bySwitch, TimeSpan? latency)
        => (Model, Seed, At, Mode, BySwitch, _latency) = (model, seed, at, mode, bySwitch, latency);

    private readonly TimeSpan? _latency;

    public SimulatedAutopilot Model { get; }

    public long Seed { get; }

    /// <summary>When the pilot changes the mode, by the clock of the run.</summary>
    public TimeSpan At { get; }

    public string Mode { get; }

    public bool BySwitch { get; }

    /// <summary>Whether the pilot's mode stood from when it was taken to the end of the window.</summary>
    public bool Stands { get; private set; }

    /// <summary>Whether the mode was the same as ours, so that nothing can be seen of it.</summary>
    public bool IsOurMode { get; private set; }

    /// <summary>A mode command that was sent after a report showed the pilot's mode; null where none was.</summary>
    public SentCommand? SentAfterReport { get; private set; }

    public string Text { get; private set; } = string.Empty;

    /// <summary>The times at which our mode commands are sent in a flight that nothing disturbs.</summary>
    public static IReadOnlyList<TimeSpan> ModeCommandTimes(
        SimulatedAutopilot model, long seed, TimeSpan latency)
    {
        using var flight = new MatrixFlight(null, model, seed, TimeSpan.Zero, latency: latency);
        while (flight.Mission.Phase is not (MissionPhase.Done or MissionPhase.Failed or MissionPhase.HandedOver))
            flight.FlyUntil(flight.Flight.Reactor.Now + TimeSpan.FromSeconds(1));
        flight.Flight.End();
        return flight.Tap.Sent.Where(s => s.ChangesMode).Select(s => s.Time).ToArray();
    }

    public static TakeoverTrial Fly(
        SimulatedAutopilot model, long seed, TimeSpan at, string mode, bool bySwitch, TimeSpan? latency = null)
    {
        var trial = new TakeoverTrial(model, seed, at, mode, bySwitch, latency);
        trial.Fly();

        // A mode that is ours already is no change of the mode, and nothing can be seen of it.
        return trial.IsOurMode && mode != NeverOurs ? Fly(model, seed, at, NeverOurs, bySwitch, latency) : trial;
    }

    public override string ToString()
        => FormattableString.Invariant(
            $"{Model} seed {Seed}: {Mode}{(BySwitch ? " by switch" : string.Empty)} at {At.TotalSeconds:0.000} s: {(Stands ? "stands" : "LOST")}{(IsOurMode ? " (our mode)" : string.Empty)}; {Text} {SentAfterReport}");

    private void Fly()
    {
        var pilot = new ScriptedFault
        {
            Kind = ScriptedFaultKind.PilotMode,
            At = At,
            Mode = Mode,
            BySwitch = BySwitch,
        };
        using var flight = new MatrixFlight(null, Model, Seed, At, holdAt: null, _latency, pilot);
        flight.FlyUntil(At - TimeSpan.FromMilliseconds(20));
        bool isEndOfTakeOff = Mode == "AUTO.LOITER" && flight.Truth.Mode == "AUTO.TAKEOFF"
            && -flight.Truth.Pose.Position.Down > EndOfTakeOffMetres;
        IsOurMode = flight.Truth.Mode == Mode || isEndOfTakeOff;
        bool wasArmed = flight.Truth.IsArmed;
        TimeSpan taken = At + (BySwitch ? SwitchTime : TimeSpan.FromMilliseconds(20));
        flight.FlyUntil(taken);

        // What our command of the same moments made of it shows within half a second.
        Stands = true;
        while (flight.Flight.Reactor.Now < At + Window)
        {
            flight.FlyUntil(flight.Flight.Reactor.Now + TimeSpan.FromMilliseconds(100));
            Stands &= flight.Truth.Mode == Mode || (wasArmed && !flight.Truth.IsArmed);
        }

        flight.Flight.End();
        Judge(flight);
    }

    private void Judge(MatrixFlight flight)
    {
        uint number = Number();
        TimeSpan? shown = flight.Tap.Reports.Where(r => r.Time >= At && r.Mode == number)
            .Select(r => (TimeSpan?)r.Time).FirstOrDefault();
        if (shown is { } time && !IsOurMode)
            SentAfterReport = flight.Tap.Sent.FirstOrDefault(s => s.ChangesMode && s.Time > time);
        SentCommand? before = flight.Tap.Sent
            .LastOrDefault(s => s.ChangesMode && s.Time <= At + TimeSpan.FromSeconds(0.2));
        Text = FormattableString.Invariant(
            $"{flight.Mission.Phase}, truly in {flight.Truth.Mode}, shown {shown?.TotalSeconds:0.000}, our command next to it {before?.What} {before?.Time.TotalSeconds:0.000}");
    }

    private uint Number()
    {
        ModeNames.TryFind(Model, Mode, out uint number);
        return number;
    }
}
