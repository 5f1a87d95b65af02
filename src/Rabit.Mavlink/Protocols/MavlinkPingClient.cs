using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Answers PING, and measures with it how long frames take to one component and back (MAVLink guide, "Ping Protocol").
/// No I/O, no clock: frames in, frames out, time as argument. One thread; nothing is allocated per frame.
/// </summary>
/// <remarks>
/// A request has the target 0/0 and so goes to every component; each answers with the same number and time, and the
/// requester as target. Answers of others than the one that is measured are ignored. TIMESYNC measures the same with
/// one component only (<see cref="MavlinkTimesyncClient"/>); PING is for what does not know TIMESYNC.
/// </remarks>
/// <example>
/// <code>
/// var ping = new MavlinkPingClient(new MavlinkSender(255, 190), new MavlinkAddress(1, 1), TimeSpan.FromSeconds(1));
///
/// // For every frame that arrives: ping.Handle(frame, now). After that, and at ping.NextDue at the latest:
/// static void Step(MavlinkPingClient ping, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (ping.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     if (ping.RoundTrip is { } roundTrip)
///         Console.WriteLine($"{roundTrip.TotalMilliseconds} ms");
/// }
/// </code>
/// </example>
public sealed class MavlinkPingClient
{
    private const int MaxOpenAnswers = 4;
    private const int MaxOpenRequests = 8;
    private const int TicksPerMicrosecond = 10;

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress? _target;
    private readonly TimeSpan _interval;
    private readonly Ping[] _answers = new Ping[MaxOpenAnswers];
    private readonly OpenRequest[] _requests = new OpenRequest[MaxOpenRequests];
    private int _answerCount;
    private uint _nextSequence;
    private TimeSpan _due = TimeSpan.MinValue;

    /// <summary>Makes one that only answers.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    public MavlinkPingClient(MavlinkSender sender)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _interval = TimeSpan.MaxValue;
    }

    /// <summary>
    /// Makes one that answers and measures, which sends requests from the first call of <see cref="TryTakeFrame"/> on.
    /// </summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">Whose answers count.</param>
    /// <param name="interval">Between two requests. Each is answered by every component that receives it.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentException">The target is not one component.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The interval is not above 0.</exception>
    public MavlinkPingClient(MavlinkSender sender, MavlinkAddress target, TimeSpan interval)
        : this(sender)
    {
        if (target.SystemId == 0 || target.ComponentId == 0)
            throw new ArgumentException("One component is measured; 0 means all.", nameof(target));
        if (interval <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(interval), interval, "The interval is above 0.");
        (_target, _interval) = (target, interval);
    }

    /// <summary>How long the last request that was answered was on its way, there and back; null before that.</summary>
    public TimeSpan? RoundTrip { get; private set; }

    /// <summary>Requests that were sent.</summary>
    public long Requests { get; private set; }

    /// <summary>Of these, those that the measured component has answered.</summary>
    public long Answers { get; private set; }

    /// <summary>Requests of others that arrived too fast to be answered.</summary>
    public long Unanswered { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for. A time in the past means at once.
    /// </summary>
    public TimeSpan NextDue => _answerCount > 0 ? TimeSpan.Zero : _target is null ? TimeSpan.MaxValue : _due;

    /// <summary>Handles a received frame; all but PING are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">When it was received: the nearer to the link this is measured, the better.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.MessageId != Ping.MavlinkId || !frame.TryDecode(out Ping ping))
            return;
        if (ping.TargetSystem == 0 && ping.TargetComponent == 0)
            Answer(frame, ping);
        else if (ping.TargetSystem == _sender.SystemId && ping.TargetComponent == _sender.ComponentId
            && _target?.IsSourceOf(frame) == true)
            Measure(ping, now);
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        if (_answerCount > 0)
        {
            frame = _sender.Create(_answers[--_answerCount]);
            return true;
        }

        frame = default;
        if (_target is null || now < _due)
            return false;
        _due = now + _interval;
        var request = new Ping { TimeUsec = (ulong)(now.Ticks / TicksPerMicrosecond), Seq = _nextSequence++ };
        _requests[request.Seq % MaxOpenRequests] = new OpenRequest { Message = request, SentAt = now, IsOpen = true };
        Requests++;
        frame = _sender.Create(request);
        return true;
    }

    // Our own request may come back over a loop of links.
    private void Answer(in MavlinkFrame frame, Ping request)
    {
        if (frame.SystemId == _sender.SystemId && frame.ComponentId == _sender.ComponentId)
            return;
        if (_answerCount == MaxOpenAnswers)
        {
            Unanswered++;
            return;
        }

        request.TargetSystem = frame.SystemId;
        request.TargetComponent = frame.ComponentId;
        _answers[_answerCount++] = request;
    }

    private void Measure(in Ping answer, TimeSpan now)
    {
        ref OpenRequest request = ref _requests[answer.Seq % MaxOpenRequests];
        if (!request.IsOpen || request.Message.Seq != answer.Seq || request.Message.TimeUsec != answer.TimeUsec)
            return;
        request.IsOpen = false;
        RoundTrip = now - request.SentAt;
        Answers++;
    }

    private struct OpenRequest
    {
        public Ping Message;
        public TimeSpan SentAt;
        public bool IsOpen;
    }
}
