using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Synchronises with the clock of one component by TIMESYNC, and answers requests for ours (MAVLink guide, "Time
/// Synchronization Protocol v2"). No I/O, no clock: frames in, frames out, time as argument. One thread; nothing is
/// allocated per frame.
/// </summary>
public sealed class MavlinkTimesyncClient
{
    private const double SecondsPerNanosecond = 1e-9;
    private const int NanosecondsPerTick = 100;
    private const int MaxOpenAnswers = 4;

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _own;
    private readonly MavlinkAddress _target;
    private readonly Timesync[] _answers = new Timesync[MaxOpenAnswers];
    private int _answerCount;

    /// <summary>Makes a client, which sends requests from the first call of <see cref="TryTakeFrame"/> on.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">The component whose clock is estimated.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    public MavlinkTimesyncClient(MavlinkSender sender, MavlinkAddress target)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _target = target;
    }

    /// <summary>The estimate.</summary>
    public MavlinkTimesyncFilter Filter { get; } = new();

    /// <summary>Requests of other components that arrived too fast to be answered.</summary>
    public long Unanswered { get; private set; }

    /// <summary>When and whether requests are sent.</summary>
    public MavlinkTimesyncRequester Requests { get; } = new();

    /// <summary>When to call <see cref="TryTakeFrame"/> at the latest.</summary>
    public TimeSpan NextDue => _answerCount > 0 || !Requests.IsStarted ? TimeSpan.Zero : Requests.NextDue;

    /// <summary>Handles a received frame; all but TIMESYNC are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">
    /// When it was received, by our clock: the nearer to the link this is measured, the better.
    /// </param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (!frame.TryDecode(out Timesync message))
            return;

        // PX4 1.14 leaves the target of its answers uninitialised; the time that we sent is a nonce that only an answer
        // to us can have.
        if (message.Tc1 == 0)
            AnswerOurs(frame, message, now);
        else if (_target.IsSourceOf(frame) && Requests.IsAnswer(message, out TimeSpan askedAt)
            && Filter.AddRoundTrip(askedAt, now, message.Tc1 * SecondsPerNanosecond))
            Requests.Hasten(now);
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        if (_answerCount > 0)
        {
            frame = _sender.Create(_answers[--_answerCount]);
            return true;
        }

        if (!Requests.IsStarted)
            Requests.Start(now);
        frame = default;
        if (!Requests.TryNext(now, out Timesync request))
            return false;
        request.TargetSystem = _target.SystemId;
        request.TargetComponent = _target.ComponentId;
        frame = _sender.Create(request);
        return true;
    }

    private void AnswerOurs(in MavlinkFrame frame, Timesync request, TimeSpan now)
    {
        if (!_own.IsTargetOf(request.TargetSystem, request.TargetComponent))
            return;
        if (_answerCount == MaxOpenAnswers)
        {
            Unanswered++;
            return;
        }

        // Never zero, which would be a request.
        request.Tc1 = (now.Ticks * NanosecondsPerTick) + 1;
        request.TargetSystem = frame.SystemId;
        request.TargetComponent = frame.ComponentId;
        _answers[_answerCount++] = request;
    }
}
