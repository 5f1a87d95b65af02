using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// One command from its first sending to its outcome (MAVLink guide, "Command Protocol"). Reused for one command after
/// another.
/// </summary>
internal sealed class CommandExchange(MavlinkCommandOptions options)
{
    private MavlinkCommand _command;
    private TimeSpan _lastSentAt;
    private TimeSpan _lastAnswerAt;
    private int _tries;
    private int _sent;
    private int _answers;
    private int _rejections;
    private bool _isInt;
    private bool _hasSwitched;
    private bool _isInProgress;

    // A sending got no answer in time: the vehicle may have received it and be at work on it.
    private bool _mayBeRunning;

    public CommandPhase Phase { get; private set; }

    public int Handle { get; private set; }

    public byte Progress { get; private set; }

    /// <summary>When it has to act next, while it is open.</summary>
    public TimeSpan Due { get; private set; }

    /// <summary>Until when a late answer to it may still arrive, once it has ended.</summary>
    public TimeSpan LateUntil { get; private set; }

    public MavlinkCommandOutcome Outcome { get; private set; }

    public bool IsOpen => Phase is CommandPhase.Sending or CommandPhase.Pausing or CommandPhase.Cancelling;

    public void Queue(int handle, in MavlinkCommand command)
    {
        Handle = handle;
        _command = command;
        Phase = CommandPhase.Queued;
        _tries = _sent = _answers = _rejections = 0;
        _isInt = command.Forms is MavlinkCommandForms.IntThenLong or MavlinkCommandForms.IntOnly;
        _hasSwitched = command.Forms is MavlinkCommandForms.IntOnly or MavlinkCommandForms.LongOnly;
        _isInProgress = _mayBeRunning = false;
        _lastAnswerAt = TimeSpan.MinValue;
        Progress = byte.MaxValue;
    }

    public void Begin(TimeSpan now)
    {
        Phase = CommandPhase.Sending;
        Due = now;
    }

    public void Release() => Phase = CommandPhase.Free;

    /// <summary>The caller has taken the outcome; late answers may still arrive.</summary>
    public void MarkOutcomeTaken() => Phase = CommandPhase.OutcomeTaken;

    /// <summary>
    /// Whether an acknowledgement of the one could be mistaken for one of the other: same command, same target.
    /// </summary>
    public bool IsSameKindAs(CommandExchange other) =>
        _command.Command == other._command.Command && _command.Target.SystemId == other._command.Target.SystemId
        && (_command.Target.ComponentId == other._command.Target.ComponentId || _command.Target.ComponentId == 0
            || other._command.Target.ComponentId == 0);

    public bool IsAnswered(in MavlinkFrame frame, in CommandAck answer) =>
        IsOpen && _sent > 0 && answer.Command == _command.Command && _command.Target.IsSourceOf(frame);

    /// <summary>Handles an answer after the end: perhaps the last outstanding one.</summary>
    /// <returns>Whether it may have been for this command.</returns>
    public bool HandleLateAnswer(in MavlinkFrame frame, in CommandAck answer, TimeSpan now)
    {
        if (Phase is not (CommandPhase.Completed or CommandPhase.OutcomeTaken) || now >= LateUntil
            || answer.Command != _command.Command || !_command.Target.IsSourceOf(frame))
            return false;
        CountAnswer(answer.Result);
        if (IsFullyAnswered)
            LateUntil = now;
        return true;
    }

    public bool TryNext(TimeSpan now, MavlinkSender sender, out MavlinkFrame frame)
    {
        frame = default;
        if (!IsOpen || now < Due)
            return false;
        bool mustNotRepeat = _isInProgress && !options.RetriesInProgress && Phase != CommandPhase.Cancelling;
        if (_tries > options.Retries || mustNotRepeat)
        {
            End(MavlinkCommandStatus.Unknown, null, 0, now);
            return false;
        }

        if (Phase == CommandPhase.Cancelling)
        {
            frame = sender.Create(new CommandCancel
            {
                TargetSystem = _command.Target.SystemId,
                TargetComponent = _command.Target.ComponentId,
                Command = _command.Command,
            });
        }
        else
        {
            _mayBeRunning |= Phase == CommandPhase.Sending && _sent > 0;
            Phase = CommandPhase.Sending;
            frame = _isInt
                ? sender.Create(_command.ToInt())
                : sender.Create(_command.ToLong((byte)Math.Min(_sent, byte.MaxValue)));
            _sent++;
        }

        _tries++;
        _lastSentAt = now;
        Due = now + options.AnswerTimeout;
        return true;
    }

    public void Cancel(TimeSpan now)
    {
        if (_sent == 0)
        {
            End(MavlinkCommandStatus.Cancelled, null, 0, now);
            LateUntil = now;
        }
        else if (Phase != CommandPhase.Cancelling)
        {
            Phase = CommandPhase.Cancelling;
            _tries = 0;
            Due = now;
        }
    }

    /// <summary>Ends it without sending anything to the vehicle.</summary>
    public void StopTracking(TimeSpan now)
    {
        End(_sent == 0 ? MavlinkCommandStatus.Cancelled : MavlinkCommandStatus.Unknown, null, 0, now);
        if (_sent == 0)
            LateUntil = now;
    }

    public void HandleAnswer(in CommandAck answer, TimeSpan now)
    {
        _lastAnswerAt = now;
        CountAnswer(answer.Result);
        switch (answer.Result)
        {
            case MavResult.InProgress:
                _isInProgress = true;
                Progress = answer.Progress;
                if (Phase == CommandPhase.Cancelling)
                    return;
                Phase = CommandPhase.Sending;
                Due = now + options.ProgressTimeout;
                return;

            // To a second copy of it, while the first is being executed or after this answer was handled already.
            case MavResult.TemporarilyRejected when _isInProgress || Phase != CommandPhase.Sending:
            case MavResult.Unsupported when Phase == CommandPhase.Pausing:
                return;

            // The vehicle may be busy with an earlier copy of this very command: that is no refusal, and gives no new
            // tries either.
            case MavResult.TemporarilyRejected when _mayBeRunning:
                Phase = CommandPhase.Pausing;
                Due = now + options.RejectionPause;
                return;
            case MavResult.TemporarilyRejected when _rejections < options.Rejections:
                _rejections++;
                PauseUntil(now + options.RejectionPause);
                return;

            // To a copy in the other form, sent before.
            case MavResult.CommandIntOnly when _isInt && _hasSwitched:
            case MavResult.CommandLongOnly or MavResult.CommandUnsupportedMavFrame
                when !_isInt && _hasSwitched && _command.Forms == MavlinkCommandForms.IntThenLong:
                return;
            case MavResult.CommandIntOnly when !_isInt && !_hasSwitched:
            case MavResult.CommandLongOnly or MavResult.CommandUnsupportedMavFrame when _isInt && !_hasSwitched:
                Switch(now);
                return;

            // An autopilot that knows the command in one form only may answer with the plain result, which must not
            // count for the other form.
            case MavResult.Unsupported when _command.HasLocation && !_hasSwitched:
                Switch(_lastSentAt + options.LateAnswerTime);
                return;
            case MavResult.Accepted:
                End(MavlinkCommandStatus.Accepted, answer.Result, answer.ResultParam2, now);
                return;
            case MavResult.Cancelled:
                End(MavlinkCommandStatus.Cancelled, answer.Result, answer.ResultParam2, now);
                return;
            default:
                End(MavlinkCommandStatus.Refused, answer.Result, answer.ResultParam2, now);
                return;
        }
    }

    // IN_PROGRESS is not final: the final answer is still outstanding.
    private void CountAnswer(MavResult result)
    {
        if (result != MavResult.InProgress)
            _answers++;
    }

    private bool IsFullyAnswered => !options.AnswersMayBeDuplicated && _answers >= _sent;

    private void Switch(TimeSpan due)
    {
        if (Phase == CommandPhase.Cancelling)
            return;
        _hasSwitched = true;
        _isInt = !_isInt;
        PauseUntil(due);
    }

    private void PauseUntil(TimeSpan due)
    {
        Phase = CommandPhase.Pausing;
        _tries = 0;
        Due = due;
    }

    private void End(MavlinkCommandStatus status, MavResult? result, int resultParam2, TimeSpan now)
    {
        Phase = CommandPhase.Completed;

        // Of the final answer, too, a duplicate may be in flight, long after the last sending of a command that took
        // long.
        LateUntil = (_sent > 0 && _lastAnswerAt > _lastSentAt ? _lastAnswerAt : _lastSentAt) + options.LateAnswerTime;
        if (status == MavlinkCommandStatus.Unknown && LateUntil < _lastSentAt + options.UnknownLateTime)
            LateUntil = _lastSentAt + options.UnknownLateTime;
        if (IsFullyAnswered)
            LateUntil = now;
        Outcome = new MavlinkCommandOutcome(Handle, _command, status, result, resultParam2, _sent, now);
    }
}
