using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Carries out vehicle commands, one at a time: step by step, each acknowledged, a mode also shown by a heartbeat.
/// Exactly one answer for each. It sends nothing unless we command, and nothing more once the command is taken away. A
/// state machine: time, commands and frames come in; frames and answers go out by its <see cref="Outbox"/>.
/// </summary>
internal sealed partial class CommandExecutor(bool mayCommand)
{
    /// <summary>
    /// How long a heartbeat may take to show a mode whose command was accepted: three at 1 Hz, two of them lost.
    /// </summary>
    public static readonly TimeSpan ModeTimeout = TimeSpan.FromSeconds(3.5);

    /// <summary>How long a text that says why may come after a refusal.</summary>
    public static readonly TimeSpan ReasonWait = TimeSpan.FromSeconds(0.3);

    // Modes, places and the like may be done twice, so that what is not answered is sent again. On the wire between
    // autopilot and companion nothing is doubled, so that what was answered need not be waited for: a command to hold
    // goes out at once.
    private static readonly MavlinkCommandOptions ExchangeOptions = new()
    {
        Rejections = 5,
        RetriesInProgress = true,
        LateAnswerTime = TimeSpan.FromSeconds(0.7),
        UnknownLateTime = TimeSpan.FromSeconds(0.7),
        AnswersMayBeDuplicated = false,
    };

    /// <summary>How long to wait for any message of an autopilot: as long as for its answers.</summary>
    public static readonly TimeSpan AutopilotWait = new(
        ExchangeOptions.AnswerTimeout.Ticks * (1 + ExchangeOptions.Retries));

    private readonly AuthorityMonitor _guard = new(mayCommand);
    private readonly VelocityStream _velocity = new();
    private readonly List<CommandStep> _steps = [];
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

    public CommandOutbox Outbox { get; } = new();

    public ref readonly CommandAuthority Authority => ref _guard.Authority;

    /// <summary>Whether something is due sooner than the manager would wake up by itself.</summary>
    public bool IsBusy => _phase != ExecutorPhase.Idle || _velocity.IsRunning;

    private bool StepAsksForMode => _step < _steps.Count && _steps[_step].Mode is not null;

    /// <summary>The autopilot is known: from now on it can be sent to.</summary>
    /// <param name="sender">Who we are.</param>
    /// <param name="target">The autopilot.</param>
    public void Connect(MavlinkSender sender, MavlinkAddress target)
    {
        _client = new MavlinkCommandClient(sender, ExchangeOptions);
        _target = target;
    }

    /// <summary>Takes a command. It replaces the one that is worked at, unless it is invalid itself.</summary>
    public void Take(in VehicleCommand command, TimeSpan now)
    {
        if (!_guard.MayCommand)
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
        Begin(command, isOurOwn: false, now);
    }

    /// <summary>Takes the state after a heartbeat of the autopilot.</summary>
    public void TakeHeartbeat(in VehicleState vehicle, TimeSpan time)
    {
        if (_guard.TakeMode(vehicle.CustomMode, vehicle.Mode, _profile, time))
        {
            StopCommanding(time);
            return;
        }

        bool isStepUnderway = _phase is ExecutorPhase.Sending or ExecutorPhase.AwaitingMode;
        if (isStepUnderway && _sent > 0 && StepAsksForMode)
            _isModeSeen = _steps[_step].Mode == vehicle.CustomMode;
    }

    /// <summary>The autopilot has rebooted.</summary>
    /// <param name="wasFlying">Whether it was in the air, or might have been.</param>
    /// <param name="time">When.</param>
    public void TakeReboot(bool wasFlying, TimeSpan time)
    {
        _lastSpeed = double.NaN;
        if (_guard.TakeReboot(wasFlying, time))
            StopCommanding(time);
    }

    /// <summary>Takes an acknowledgement, which may be the autopilot's to us.</summary>
    public void TakeAcknowledgement(in MavlinkFrame frame, in CommandAck acknowledgement, TimeSpan now)
        => _client?.Handle(frame, acknowledgement, now);

    /// <summary>
    /// Takes a text of the vehicle: the newest one that came with a refusal, and is no mere information, is its reason.
    /// </summary>
    public void TakeText(MavSeverity severity, string text)
    {
        if (_phase != ExecutorPhase.Idle && severity <= MavSeverity.Warning)
            _reason = text;
    }

    /// <summary>Does what is due.</summary>
    public void Run(in VehicleState vehicle, in OwnAddress own, TimeSpan now)
    {
        // Each iteration ends a phase; a command has a handful of steps.
        while (RunPhase(vehicle, now))
        {
        }

        WatchDeadMan(now);
        while (RunPhase(vehicle, now))
        {
        }

        if (_velocity.TryNext(now, own, vehicle, out MavlinkFrame frame))
            Outbox.Frames.Enqueue(frame);
    }

    private void WatchDeadMan(TimeSpan now)
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
            _owesHold = false;
        Enter(ExecutorPhase.Planning, now);
    }

    private void Enter(ExecutorPhase phase, TimeSpan now)
    {
        _phase = phase;
        _phaseSince = now;
    }

    private void StopCommanding(TimeSpan now)
    {
        _velocity.Stop();
        _owesHold = false;
        string text = NotInCommandText();
        Outbox.Notes.Enqueue(text);
        if (_phase != ExecutorPhase.Idle)
            Finish(VehicleCommandOutcome.NotInCommand, text, now);
    }

    private void Finish(VehicleCommandOutcome outcome, string? text, TimeSpan now)
    {
        if (!_isOurOwn)
            Answer(_command, outcome, text);
        else if (outcome is not (VehicleCommandOutcome.Accepted or VehicleCommandOutcome.Replaced))
            Outbox.Notes.Enqueue($"holding: {outcome}, {text}");
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
