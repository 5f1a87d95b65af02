using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// One command that was received, from its first copy until it can arrive no more. Reused for one command after
/// another.
/// </summary>
internal sealed class CommandExecution(MavlinkCommandServerOptions options)
{
    private MavlinkCommandRequest _request;
    private MavResult _result;
    private int _resultParam2;
    private TimeSpan _lastCopyAt;
    private TimeSpan _progressDue;
    private byte _sequence;
    private bool _isAnswerDue;
    private bool _tookLong;

    private enum Phase
    {
        Free,
        Received,
        Running,
        Completed,
    }

    private Phase _phase;

    public int Handle => _request.Handle;

    public ref readonly MavlinkCommandRequest Request => ref _request;

    /// <summary>Percent; 255 where it is not known.</summary>
    public byte Progress { private get; set; }

    public MavlinkCommandCancellation? Cancellation { get; set; }

    public bool IsWaiting => _phase == Phase.Received;

    public bool IsOpen => _phase is Phase.Received or Phase.Running;

    public bool IsRunning => _phase == Phase.Running;

    public bool IsKept => _phase == Phase.Completed;

    public bool IsAnswerDue => _isAnswerDue;

    /// <summary>When its result was given, or its last copy received.</summary>
    public TimeSpan LastCopyAt => _lastCopyAt;

    /// <summary>When it has to send something.</summary>
    public TimeSpan Due => _isAnswerDue ? TimeSpan.Zero : IsOpen ? _progressDue : TimeSpan.MaxValue;

    public bool IsFree(TimeSpan now)
        => _phase == Phase.Free
            || (_phase == Phase.Completed && !_isAnswerDue && !IsRemembered(now, isConfirmed: true));

    public void Begin(in MavlinkCommandRequest request, byte sequence)
    {
        _request = request;
        _sequence = sequence;
        _phase = Phase.Received;
        _lastCopyAt = request.ReceivedAt;
        _progressDue = request.ReceivedAt + options.ProgressInterval;
        _isAnswerDue = _tookLong = false;
        Progress = byte.MaxValue;
        Cancellation = null;
    }

    public void Take() => _phase = Phase.Running;

    public void Complete(MavResult result, int resultParam2, TimeSpan now)
    {
        (_result, _resultParam2) = (result, resultParam2);
        _phase = Phase.Completed;
        _lastCopyAt = now;
        _isAnswerDue = true;
        Cancellation = null;
    }

    public bool IsSameKindAs(in MavlinkCommandRequest request) => _phase != Phase.Free
        && _request.Command.Command == request.Command.Command && _request.Source == request.Source;

    /// <summary>Whether a frame has the command of this one, still remembered, from the same sender.</summary>
    public bool IsCopyOf(in MavlinkCommandRequest request, bool isConfirmed) => _phase != Phase.Free
        && (IsOpen || _isAnswerDue || IsRemembered(request.ReceivedAt, isConfirmed))
        && _request.Source == request.Source && _request.Command == request.Command;

    public bool HasSequence(byte sequence) => _sequence == sequence;

    /// <summary>Answers a copy: with the result where there is one.</summary>
    public void Repeat(byte sequence, TimeSpan now)
    {
        _sequence = sequence;
        _lastCopyAt = now;
        if (_phase == Phase.Completed)
            _isAnswerDue = true;
        else if (now >= _request.ReceivedAt + options.ProgressInterval)
            _progressDue = now;
    }

    /// <summary>Answers again, for a sender that has not received the result.</summary>
    public void AnswerAgain() => _isAnswerDue = true;

    public bool TryNext(TimeSpan now, MavlinkSender sender, out MavlinkFrame frame)
    {
        frame = default;
        if (now < Due || _phase == Phase.Free)
            return false;
        bool isFinal = _phase == Phase.Completed;
        frame = sender.Create(new CommandAck
        {
            Command = _request.Command.Command,
            Result = isFinal ? _result : MavResult.InProgress,
            Progress = isFinal ? byte.MaxValue : Progress,
            ResultParam2 = isFinal ? _resultParam2 : 0,
            TargetSystem = _request.Source.SystemId,
            TargetComponent = _request.Source.ComponentId,
        });
        _isAnswerDue = false;
        _tookLong |= !isFinal;
        _progressDue = now + options.ProgressInterval;

        // What was rejected for now must be looked at again when it is sent again.
        if (isFinal && _result == MavResult.TemporarilyRejected)
            _phase = Phase.Free;
        return true;
    }

    // After IN_PROGRESS a sender waits longer before it sends again.
    private bool IsRemembered(TimeSpan now, bool isConfirmed)
        => now < _lastCopyAt + (isConfirmed || _tookLong ? options.ConfirmedRepeatTime : options.RepeatTime);
}
