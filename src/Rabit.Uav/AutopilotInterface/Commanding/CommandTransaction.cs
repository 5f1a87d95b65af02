using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// One MAVLink command until it is acknowledged (MAVLink guide, "Command Protocol"): 0.7 s and four tries; "in progress" prolongs,
/// "temporarily rejected" is tried again after a pause. A state machine: time and acknowledgements come in, tries go out.
/// </summary>
internal sealed class CommandTransaction
{
    /// <summary>How long one try waits. The guide leaves it open; MAVSDK and PX4 wait 0.5 s, a slow radio needs a little more.</summary>
    public static readonly TimeSpan AnswerTimeout = TimeSpan.FromSeconds(0.7);

    /// <summary>How often it is sent without any answer.</summary>
    public const int MaximumTries = 4;

    /// <summary>How long to wait for the end of what is in progress, counted from each sign of progress.</summary>
    public static readonly TimeSpan ProgressTimeout = TimeSpan.FromSeconds(5);

    /// <summary>How long after a temporary rejection it is sent again.</summary>
    public static readonly TimeSpan RejectionPause = TimeSpan.FromSeconds(1);

    /// <summary>How often it may be rejected for now before that counts as a refusal.</summary>
    public const int MaximumRejections = 5;

    private TimeSpan _due;
    private int _rejections;
    private bool _isOver;

    /// <summary>How often it was sent since the start or the last temporary rejection.</summary>
    public int Tries { get; private set; }

    /// <summary>How often it was sent altogether.</summary>
    public int Sent { get; private set; }

    /// <summary>The last word of the autopilot; null while there is none, and where there never was one.</summary>
    public MavResult? Result { get; private set; }

    /// <summary>Whether nothing more is to be done, with or without a result.</summary>
    public bool IsOver => _isOver;

    public void Begin(TimeSpan now)
    {
        _due = now;
        _rejections = 0;
        _isOver = false;
        Tries = 0;
        Sent = 0;
        Result = null;
    }

    /// <summary>Says whether to send it now.</summary>
    /// <param name="now">The time.</param>
    /// <param name="confirmation">How often it was sent before.</param>
    public bool TryNext(TimeSpan now, out byte confirmation)
    {
        confirmation = (byte)Tries;
        if (_isOver || now < _due)
            return false;
        if (Tries == MaximumTries)
        {
            _isOver = true;
            return false;
        }

        Tries++;
        Sent++;
        _due = now + AnswerTimeout;
        return true;
    }

    /// <summary>Takes an acknowledgement of the command.</summary>
    public void Take(MavResult result, TimeSpan now)
    {
        if (_isOver)
            return;
        switch (result)
        {
            case MavResult.InProgress:
                _due = now + ProgressTimeout;
                return;
            case MavResult.TemporarilyRejected when Tries == 0:
                return;   // a second answer, to a repetition, while the pause goes on
            case MavResult.TemporarilyRejected when _rejections < MaximumRejections:
                _rejections++;
                Tries = 0;
                _due = now + RejectionPause;
                return;
            default:
                Result = result;
                _isOver = true;
                return;
        }
    }
}
