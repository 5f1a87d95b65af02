using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Asks for reports of the flight mode: HEARTBEAT by MAV_CMD_REQUEST_MESSAGE, which ArduPilot and PX4 answer within
/// milliseconds, where PX4 refuses an interval for it. A state machine: time and reports come in, requests go out.
/// </summary>
/// <remarks>
/// The requests are repeated by themselves and need no acknowledgement: the report is the answer. Where the autopilot
/// denies them, its own heartbeats serve, once a second.
/// </remarks>
internal sealed class ModeReportRequester
{
    /// <summary>While we command: a pilot's change of the mode is seen within it.</summary>
    public static readonly TimeSpan Period = TimeSpan.FromMilliseconds(200);

    /// <summary>While set-points are streamed, which goes on only as long as reports come.</summary>
    public static readonly TimeSpan StreamingPeriod = TimeSpan.FromMilliseconds(100);

    /// <summary>After what time a wanted report is asked for again.</summary>
    public static readonly TimeSpan AnswerTimeout = TimeSpan.FromMilliseconds(300);

    // Where each report asks for the next one: no more of them than an autopilot's loop of 100 Hz answers.
    private static readonly TimeSpan MinPeriod = TimeSpan.FromMilliseconds(10);

    // It may have been busy, or another autopilot by now.
    private static readonly TimeSpan PauseAfterDenial = TimeSpan.FromSeconds(10);

    // After a stall, or while the link was gone, frames wait in buffers: what is received meanwhile says what was, not
    // what is.
    private static readonly TimeSpan SettlingTime = TimeSpan.FromMilliseconds(50);

    // A second at 10 Hz; the oldest lost ones go.
    private const int MaxUnacknowledged = 10;

    private readonly Queue<TimeSpan> _unacknowledged = new();
    private TimeSpan _shortestRoundTrip = TimeSpan.MaxValue;
    private TimeSpan? _uplinkProvenAt;
    private TimeSpan _countsFrom = TimeSpan.MinValue;
    private TimeSpan? _lastRequestAt;
    private bool _isUnanswered;
    private TimeSpan? _deniedAt;
    private bool _isWanted;

    /// <summary>When the last report was received; null before the first.</summary>
    public TimeSpan? ReportedAt { get; private set; }

    /// <summary>Whether the autopilot denied the last request.</summary>
    public bool IsDenied(TimeSpan now) => _deniedAt is { } at && now - at < PauseAfterDenial;

    /// <summary>A report is wanted at once, unless one was asked for a moment ago.</summary>
    public void RequestNow() => _isWanted = true;

    /// <summary>Whether a report was received that answers to a request, or came after it.</summary>
    /// <param name="wantedAt">When it was wanted.</param>
    public bool HasReportSince(TimeSpan wantedAt) => ReportedAt >= wantedAt && ReportedAt >= _countsFrom;

    /// <summary>
    /// Until when both ways of the link are proven: a report was received, and the autopilot acknowledged a request
    /// that was sent then. Its own heartbeats prove one way only. Null where nothing is proven.
    /// </summary>
    /// <param name="now">The time.</param>
    public TimeSpan? ProvenAt(TimeSpan now)
    {
        if (ReportedAt is not { } reported || reported < _countsFrom)
            return null;
        if (IsDenied(now))
            return reported;
        return _uplinkProvenAt is { } uplink && uplink < reported ? uplink : _uplinkProvenAt is null ? null : reported;
    }

    /// <summary>There was a gap, here or on the link: what was asked for and received before proves nothing.</summary>
    public void Forget(TimeSpan now)
    {
        _unacknowledged.Clear();
        _uplinkProvenAt = null;
        _countsFrom = now + SettlingTime;
        _isUnanswered = false;
        _isWanted = true;
    }

    /// <summary>Takes the report of the autopilot.</summary>
    /// <param name="time">When it was received.</param>
    public void TakeReport(TimeSpan time)
    {
        ReportedAt = time;
        _isUnanswered = false;
    }

    /// <summary>Takes the acknowledgement of a request.</summary>
    public void TakeAcknowledgement(MavResult result, TimeSpan time)
    {
        if (result is MavResult.Denied or MavResult.Unsupported)
            _deniedAt = time;
        if (_unacknowledged.Count == 1 && time - _unacknowledged.Peek() < _shortestRoundTrip)
            _shortestRoundTrip = time - _unacknowledged.Peek();

        // It may be for any request that is a round trip old; those before it were lost.
        TimeSpan? acknowledged = null;
        while (_unacknowledged.Count > 0
            && (acknowledged is null || time - _unacknowledged.Peek() >= _shortestRoundTrip))
            acknowledged = _unacknowledged.Dequeue();
        _uplinkProvenAt = acknowledged ?? _uplinkProvenAt;
    }

    /// <summary>Another autopilot, or the same after a reboot.</summary>
    public void Restart()
    {
        _deniedAt = null;
        _isUnanswered = false;
    }

    /// <summary>The request that is due.</summary>
    /// <param name="now">The time.</param>
    /// <param name="period">How often reports are wanted.</param>
    /// <param name="sender">Who asks.</param>
    /// <param name="target">The autopilot.</param>
    /// <param name="frame">The request.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryNext(
        TimeSpan now, TimeSpan period, MavlinkSender sender, MavlinkAddress target, out MavlinkFrame frame)
    {
        frame = default;
        if (IsDenied(now) || now < _countsFrom || NextDue(period) > now)
            return false;
        _lastRequestAt = now;
        if (_unacknowledged.Count == MaxUnacknowledged)
            _unacknowledged.Dequeue();
        _unacknowledged.Enqueue(now);
        _isUnanswered = true;
        _isWanted = false;
        frame = sender.Create(new CommandLong
        {
            TargetSystem = target.SystemId,
            TargetComponent = target.ComponentId,
            Command = MavCmd.RequestMessage,
            Param1 = Heartbeat.MavlinkId,
        });
        return true;
    }

    /// <summary>When the next request is due.</summary>
    /// <param name="period">How often reports are wanted.</param>
    public TimeSpan NextDue(TimeSpan period)
    {
        if (_lastRequestAt is not { } last)
            return TimeSpan.Zero;
        TimeSpan due = _isWanted && !_isUnanswered ? last + MinPeriod
            : last + (_isUnanswered && period > AnswerTimeout ? AnswerTimeout : period);
        return due > _countsFrom ? due : _countsFrom;
    }
}
