using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Asks the autopilot for message rates, one message at a time: MAV_CMD_SET_MESSAGE_INTERVAL, then wait for its
/// acknowledgement (MAVLink guide, "Requesting messages" and "Command Protocol"). A state machine: time comes in, commands go out.
/// </summary>
/// <remarks>
/// An acknowledgement does not say which message it is for. One that comes later than the time-out of all tries is taken for
/// that of the next message; the count of accepted ones may then be off by one, the rates are not.
/// </remarks>
internal sealed class MessageRateRequester(IReadOnlyList<RequestedRate> rates)
{
    /// <summary>How long to wait for an acknowledgement. The guide leaves it open; an autopilot on a slow radio needs well below a second.</summary>
    public static readonly TimeSpan AnswerTimeout = TimeSpan.FromSeconds(1);

    /// <summary>How often one message is asked for before the next one is.</summary>
    public const int MaximumTries = 3;

    private int _next;
    private int _tries;
    private bool _isWaiting;
    private bool _isStarted;
    private TimeSpan _sentAt;
    private long _accepted;
    private long _refused;
    private long _unanswered;
    private long _sent;

    public RateRequestCounts Counts => new(_accepted, _refused, _unanswered, _sent);

    /// <summary>Begins with the first message, whatever became of it before.</summary>
    public void Start()
    {
        _isStarted = true;
        MoveTo(0);
    }

    /// <summary>Asks for nothing until the next start: nobody listens.</summary>
    public void Stop() => _isStarted = false;

    /// <summary>Says what to send now, if anything.</summary>
    /// <param name="now">The time.</param>
    /// <param name="command">The command; addressees are the caller's to fill in.</param>
    /// <param name="gaveUp">The message that was asked for in vain just now, or null.</param>
    public bool TryNext(TimeSpan now, out CommandLong command, out int? gaveUp)
    {
        command = default;
        gaveUp = null;
        if (!_isStarted || _next == rates.Count || (_isWaiting && now - _sentAt < AnswerTimeout))
            return false;
        if (_tries == MaximumTries)
        {
            gaveUp = rates[_next].MessageId;
            _unanswered++;
            MoveTo(_next + 1);
            return TrySend(now, out command);
        }

        return TrySend(now, out command);
    }

    /// <summary>Takes an acknowledgement of <see cref="MavCmd.SetMessageInterval"/> by the autopilot, for us or for everybody.</summary>
    /// <returns>The message that was refused just now, or null.</returns>
    public int? TakeAnswer(MavResult result, TimeSpan now)
    {
        if (!_isStarted || !_isWaiting)
            return null;
        switch (result)
        {
            case MavResult.Accepted:
                _accepted++;
                MoveTo(_next + 1);
                return null;
            case MavResult.InProgress:
                _sentAt = now;
                return null;
            case MavResult.TemporarilyRejected:
                return null;   // the time-out asks again
            default:
                int refused = rates[_next].MessageId;
                _refused++;
                MoveTo(_next + 1);
                return refused;
        }
    }

    private bool TrySend(TimeSpan now, out CommandLong command)
    {
        command = default;
        if (_next == rates.Count)
            return false;
        RequestedRate rate = rates[_next];
        command.Command = MavCmd.SetMessageInterval;
        command.Confirmation = (byte)_tries;
        command.Param1 = rate.MessageId;
        command.Param2 = (float)Math.Round(1e6 / rate.Hertz);
        _tries++;
        _sent++;
        _sentAt = now;
        _isWaiting = true;
        return true;
    }

    private void MoveTo(int next)
    {
        _next = next;
        _tries = 0;
        _isWaiting = false;
    }
}
