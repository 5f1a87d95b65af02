using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>One command from its first sending to its outcome (MAVLink guide, "Command Protocol"). Used again and again.</summary>
internal sealed class CommandExchange(MavlinkCommandOptions options)
{
    private MavlinkCommand _command;
    private TimeSpan _lastSentAt;
    private TimeSpan _lastHeardAt;
    private int _tries;
    private int _sent;
    private int _answers;
    private int _rejections;
    private bool _isInt;
    private bool _hasSwitched;
    private bool _isInProgress;

    public CommandPhase Phase { get; private set; }

    public int Handle { get; private set; }

    public byte Progress { get; private set; }

    /// <summary>When the next thing is to be done, while it is open.</summary>
    public TimeSpan Due { get; private set; }

    /// <summary>Until when an answer to it may still come in, once it is over.</summary>
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
        _isInProgress = false;
        _lastHeardAt = TimeSpan.MinValue;
        Progress = byte.MaxValue;
    }

    public void Begin(TimeSpan now)
    {
        Phase = CommandPhase.Sending;
        Due = now;
    }

    public void Free() => Phase = CommandPhase.Free;

    /// <summary>The outcome is with the caller; answers may still come.</summary>
    public void Settle() => Phase = CommandPhase.Settled;

    /// <summary>Whether an answer to the one could be taken for an answer to the other.</summary>
    public bool IsLike(CommandExchange other) =>
        _command.Command == other._command.Command && _command.Target.SystemId == other._command.Target.SystemId
        && (_command.Target.ComponentId == other._command.Target.ComponentId || _command.Target.ComponentId == 0 || other._command.Target.ComponentId == 0);

    public bool IsAnswered(in MavlinkFrame frame, in CommandAck answer) =>
        IsOpen && _sent > 0 && answer.Command == _command.Command && _command.Target.IsSourceOf(frame);

    /// <summary>Takes an answer that comes after the end: perhaps the last one that was still to come.</summary>
    /// <returns>Whether it may have been for this command.</returns>
    public bool TakeLate(in MavlinkFrame frame, in CommandAck answer, TimeSpan now)
    {
        if (Phase is not (CommandPhase.Over or CommandPhase.Settled) || now >= LateUntil || answer.Command != _command.Command || !_command.Target.IsSourceOf(frame))
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
        bool isWaitedFor = _isInProgress && !options.RetriesInProgress && Phase != CommandPhase.Cancelling;
        if (_tries > options.Retries || isWaitedFor)
        {
            End(MavlinkCommandVerdict.Unknown, null, 0, now);
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
            Phase = CommandPhase.Sending;
            frame = _isInt ? sender.Create(_command.ToInt()) : sender.Create(_command.ToLong((byte)Math.Min(_sent, byte.MaxValue)));
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
            End(MavlinkCommandVerdict.Cancelled, null, 0, now);
            LateUntil = now;
        }
        else if (Phase != CommandPhase.Cancelling)
        {
            Phase = CommandPhase.Cancelling;
            _tries = 0;
            Due = now;
        }
    }

    /// <summary>Ends it without a word to the vehicle.</summary>
    public void Abandon(TimeSpan now)
    {
        End(_sent == 0 ? MavlinkCommandVerdict.Cancelled : MavlinkCommandVerdict.Unknown, null, 0, now);
        if (_sent == 0)
            LateUntil = now;
    }

    public void Take(in CommandAck answer, TimeSpan now)
    {
        _lastHeardAt = now;
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

            // To a second copy of it, while the first is at work or after this answer was taken already.
            case MavResult.TemporarilyRejected when _isInProgress || Phase != CommandPhase.Sending:
            case MavResult.Unsupported when Phase == CommandPhase.Pausing:
                return;
            case MavResult.TemporarilyRejected when _rejections < options.Rejections:
                _rejections++;
                PauseUntil(now + options.RejectionPause);
                return;

            // To a copy in the other form, sent before.
            case MavResult.CommandIntOnly when _isInt && _hasSwitched:
            case MavResult.CommandLongOnly or MavResult.CommandUnsupportedMavFrame when !_isInt && _hasSwitched && _command.Forms == MavlinkCommandForms.IntThenLong:
                return;
            case MavResult.CommandIntOnly when !_isInt && !_hasSwitched:
            case MavResult.CommandLongOnly or MavResult.CommandUnsupportedMavFrame when _isInt && !_hasSwitched:
                Switch(now);
                return;

            // An autopilot that knows the command in one form only may say so with the plain result. What it said of this form must not count for the other.
            case MavResult.Unsupported when _command.HasPlace && !_hasSwitched:
                Switch(_lastSentAt + options.LateAnswerTime);
                return;
            case MavResult.Accepted:
                End(MavlinkCommandVerdict.Accepted, answer.Result, answer.ResultParam2, now);
                return;
            case MavResult.Cancelled:
                End(MavlinkCommandVerdict.Cancelled, answer.Result, answer.ResultParam2, now);
                return;
            default:
                End(MavlinkCommandVerdict.Refused, answer.Result, answer.ResultParam2, now);
                return;
        }
    }

    // "In progress" is a word in between; the answer is still to come.
    private void CountAnswer(MavResult result)
    {
        if (result != MavResult.InProgress)
            _answers++;
    }

    private bool IsFullyAnswered => !options.AnswersMayDouble && _answers >= _sent;

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

    private void End(MavlinkCommandVerdict verdict, MavResult? result, int resultParam2, TimeSpan now)
    {
        Phase = CommandPhase.Over;

        // Also of the last word there may be a copy under way, long after the last sending of what took long.
        LateUntil = (_sent > 0 && _lastHeardAt > _lastSentAt ? _lastHeardAt : _lastSentAt) + options.LateAnswerTime;
        if (verdict == MavlinkCommandVerdict.Unknown && LateUntil < _lastSentAt + options.UnknownLateTime)
            LateUntil = _lastSentAt + options.UnknownLateTime;
        if (IsFullyAnswered)
            LateUntil = now;
        Outcome = new MavlinkCommandOutcome(Handle, _command, verdict, result, resultParam2, _sent, now);
    }
}
