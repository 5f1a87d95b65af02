using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Carries out vehicle commands, one at a time: step by step, each acknowledged, a mode also shown by a report. Exactly
/// one answer for each. It sends nothing unless we command, and nothing more once the command is taken away. A state
/// machine: time, commands and frames come in; frames and answers go out by its <see cref="Outbox"/>.
/// </summary>
internal sealed partial class CommandExecutor(bool mayCommand, bool mayCommandFixedWing)
{
    /// <summary>
    /// How long a report may take to show a mode whose command was accepted: three heartbeats, two of them lost.
    /// </summary>
    public static readonly TimeSpan ModeTimeout = TimeSpan.OfSeconds(3.5);

    /// <summary>How long a text that says why may come after a refusal.</summary>
    public static readonly TimeSpan ReasonWait = TimeSpan.OfSeconds(0.3);

    // Modes, places and the like may be done twice, so that what is not answered is sent again. On the wire between
    // autopilot and companion nothing is doubled, so that what was answered need not be waited for: a command to hold
    // goes out at once.
    private static readonly MavlinkCommandOptions ExchangeOptions = new()
    {
        Rejections = 5,
        RetriesInProgress = true,
        LateAnswerTime = TimeSpan.OfSeconds(0.7),
        UnknownLateTime = TimeSpan.OfSeconds(0.7),
        AnswersMayBeDuplicated = false,
    };

    /// <summary>How long to wait for any message of an autopilot: as long as for its answers.</summary>
    public static readonly TimeSpan AutopilotWait = new(
        ExchangeOptions.AnswerTimeout.Ticks * (1 + ExchangeOptions.Retries));

    private readonly AuthorityMonitor _guard = new(mayCommand);
    private readonly VelocityStream _velocity = new();
    private readonly OffboardStream _stream = new();
    private readonly List<CommandStep> _steps = [];
    private MavlinkSender? _sender;
    private MavlinkCommandClient? _client;
    private MavlinkAddress _target;
    private VehicleProfile? _profile;
    private VehicleCommand _command;
    private ExecutorPhase _phase;
    private bool _isOurOwn;
    private int _step;
    private int _handle;
    private int _sent;
    private bool _isModeSeen;
    private bool _owesHold;
    private TimeSpan _begunAt;
    private TimeSpan _phaseSince;
    private string? _reason;
    private double _lastSpeed = double.NaN;
    private double _takeOffHeight = double.NaN;

    public CommandOutbox Outbox { get; } = new();

    public ref readonly CommandAuthority Authority => ref _guard.Authority;

    /// <summary>Whether something is due sooner than the manager would wake up by itself.</summary>
    public bool IsBusy => _phase != ExecutorPhase.Idle || _velocity.IsRunning || _stream.IsRunning
        || _guard.NeedsReport;

    private bool StepAsksForMode => _step < _steps.Count && _steps[_step].Mode is not null;

    /// <summary>The autopilot is known: from now on it can be sent to.</summary>
    /// <param name="sender">Who we are.</param>
    /// <param name="target">The autopilot.</param>
    public void Connect(MavlinkSender sender, MavlinkAddress target)
    {
        _sender = sender;
        _client = new MavlinkCommandClient(sender, ExchangeOptions);
        _target = target;
    }

    /// <summary>
    /// Takes a command. It replaces the one that is worked at, unless it is invalid itself. One with the id of the
    /// newest is a renewal, which has no answer.
    /// </summary>
    public void Take(in VehicleCommand command, TimeSpan now)
    {
        if (_validity.TryRenew(command, now))
            return;
        if (!_guard.MayCommand && !IsTakingControl(command))
        {
            Answer(command, VehicleCommandOutcome.NotInCommand, NotInCommandText());
            return;
        }

        if (CommandCheck.FindFault(command) is { } fault)
        {
            Answer(command, VehicleCommandOutcome.Refused, fault);
            return;
        }

        if (_phase != ExecutorPhase.Idle)
            Finish(VehicleCommandOutcome.Replaced, $"{command.Kind} came before it was done", now);
        _validity.Take(command, now);
        _guard.SetReturningByItself(false);
        Begin(command, isOurOwn: false, now);
    }

    /// <summary>Does what is due.</summary>
    public void Run(in VehicleState vehicle, in OwnAddress own, TimeSpan now)
    {
        // Each iteration ends a phase; a command has a handful of steps.
        while (RunPhase(vehicle, now))
        {
        }

        WatchVelocity(now);
        WatchValidity(vehicle, now);
        while (RunPhase(vehicle, now))
        {
        }

        RunStreams(vehicle, own, now);
        RequestReports(now);
    }

    private bool IsTakingControl(in VehicleCommand command)
        => command.Kind == VehicleCommandKind.TakeControl
            && _guard.Authority.State != CommandAuthorityState.Observing;

    private void WatchVelocity(TimeSpan now)
    {
        if (_velocity.IsDead(now))
        {
            _velocity.Stop();
            _owesHold = true;
            Outbox.Notes.Enqueue("no velocity came for 1.5 s: the vehicle is commanded to hold");
        }

        if (_owesHold && _phase == ExecutorPhase.Idle)
            Begin(new VehicleCommand { Kind = VehicleCommandKind.Hold }, isOurOwn: true, now);
    }

    private void Begin(in VehicleCommand command, bool isOurOwn, TimeSpan now)
    {
        _command = command;
        _isOurOwn = isOurOwn;
        _begunAt = now;
        _steps.Clear();
        _step = 0;

        // The camera is turned while the vehicle flies on; a velocity is followed by the next one.
        if (command.Kind is not (VehicleCommandKind.Velocity or VehicleCommandKind.PointCamera))
            _velocity.Stop();
        if (command.Kind != VehicleCommandKind.PointCamera)
        {
            _owesHold = false;
            if (command.Kind == VehicleCommandKind.Velocity)
                StopWatchingTargets();

            // In OFFBOARD set-points go on until another mode is reported.
            if (command.Kind != VehicleCommandKind.GoTo && !_stream.IsInOffboard)
                _stream.Stop();
        }

        Enter(
            command.Kind == VehicleCommandKind.TakeControl ? ExecutorPhase.TakingControl : ExecutorPhase.Planning, now);
    }

    private void Enter(ExecutorPhase phase, TimeSpan now)
    {
        _phase = phase;
        _phaseSince = now;
    }

    private void StopCommanding(TimeSpan now)
    {
        _velocity.Stop();
        _stream.Stop();
        StopWatchingTargets();
        _validity.Stop();
        _owesHold = false;
        string text = NotInCommandText();
        Outbox.Notes.Enqueue(text);
        if (_phase != ExecutorPhase.Idle)
            Finish(VehicleCommandOutcome.NotInCommand, text, now);
    }

    private void Finish(VehicleCommandOutcome outcome, string? text, TimeSpan now)
    {
        bool isRefused = outcome is not (VehicleCommandOutcome.Accepted or VehicleCommandOutcome.Replaced);
        if (!_isOurOwn)
            Answer(_command, outcome, text);
        else if (isRefused)
            Outbox.Notes.Enqueue($"{(_command.Kind == VehicleCommandKind.Hold ? "holding" : "returning")}: {outcome}, {text}");
        if (isRefused && !_stream.IsInOffboard)
            _stream.Stop();
        _phase = ExecutorPhase.Idle;
        _steps.Clear();
        _step = 0;
        _client?.StopTracking(_handle, now);
    }

    private void Answer(in VehicleCommand command, VehicleCommandOutcome outcome, string? text)
        => Outbox.Answers.Enqueue(
            new VehicleCommandResult { Id = command.Id, Kind = command.Kind, Outcome = outcome, Text = text });

    private string NotInCommandText() => _guard.Authority.State == CommandAuthorityState.Observing
        ? "observing only"
        : $"{_guard.Authority.TakenBy} took the command away";
}
