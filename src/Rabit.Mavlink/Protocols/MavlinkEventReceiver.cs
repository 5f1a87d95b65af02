using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Receives the events of one component (MAVLink guide, "Events Interface"): each once, as soon as it arrives, and
/// asks again for those that were lost. No I/O, no clock: frames in, frames out, time as argument. One thread; nothing
/// is allocated per frame.
/// </summary>
/// <remarks>
/// It begins with the first event that arrives. An event that was lost is asked for by its number and comes late
/// (<see cref="MavlinkEvent.IsRecovered"/>); what the component does not have any more, and what does not come after
/// eight requests, is counted as lost. A restart of the component is seen by its numbers and times, and by the flag
/// that it sends; <see cref="Restart"/> says so where the caller knows it.
/// </remarks>
/// <example>
/// <code>
/// var events = new MavlinkEventReceiver(new MavlinkSender(255, 190), new MavlinkAddress(1, 1));
///
/// // For every frame that arrives: events.Handle(frame, now). After that, and at events.NextDue at the latest:
/// static void Step(MavlinkEventReceiver events, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (events.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     while (events.TryTake(out MavlinkEvent happened))
///         Console.WriteLine(happened);
/// }
/// </code>
/// </example>
public sealed class MavlinkEventReceiver
{
    private const int Window = 64;
    private const int MaxWaiting = 64;
    private const int MaxRequests = 8;

    // An event that was sent later happened later; what is that much older is of a component that has started again.
    private const uint RestartMilliseconds = 10_000;

    // Not in "times": nothing is known of the event of that number.
    private const uint NoTime = uint.MaxValue;

    private static readonly TimeSpan AnswerTimeout = TimeSpan.OfSeconds(0.5);

    // What has only been overtaken is not asked for.
    private static readonly TimeSpan ReorderTime = TimeSpan.OfSeconds(0.1);

    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _own;
    private readonly MavlinkAddress _target;
    private readonly uint[] _times = new uint[Window];
    private readonly MavlinkEvent[] _waiting = new MavlinkEvent[MaxWaiting];
    private int _firstWaiting;
    private int _waitingCount;

    // The highest number so far, and for it and the 63 before it whether they are settled: received, or given up.
    private bool _hasBegun;
    private ushort _highest;
    private ulong _settled;
    private uint _newestTime;
    private TimeSpan _due;
    private ushort _asked;
    private ushort _askedLast;
    private int _tries;

    /// <summary>Makes a receiver.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">Whose events.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentException">The target is not one component.</exception>
    public MavlinkEventReceiver(MavlinkSender sender, MavlinkAddress target)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        if (target.SystemId == 0 || target.ComponentId == 0)
            throw new ArgumentException("Events are those of one component; 0 means all.", nameof(target));
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _target = target;
    }

    /// <summary>Events that were received, each once.</summary>
    public long Received { get; private set; }

    /// <summary>Of these, those that had to be asked for.</summary>
    public long Recovered { get; private set; }

    /// <summary>Events that did not come, or that the component does not have any more.</summary>
    public long Lost { get; private set; }

    /// <summary>Copies of events.</summary>
    public long Repeats { get; private set; }

    /// <summary>Events that were not taken out in time: the oldest were dropped.</summary>
    public long Dropped { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while nothing is missing.
    /// </summary>
    public TimeSpan NextDue => _hasBegun && _settled != ulong.MaxValue ? _due : TimeSpan.MaxValue;

    /// <summary>The component has started again: its next event is its first.</summary>
    public void Restart() => _hasBegun = false;

    /// <summary>Handles a received frame; all but the event messages of the component are ignored.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (!_target.IsSourceOf(frame))
            return;
        switch (frame.MessageId)
        {
            case Event.MavlinkId when frame.TryDecode(out Event message):
                Take(message, now);
                break;
            case CurrentEventSequence.MavlinkId when frame.TryDecode(out CurrentEventSequence current):
                Take(current, now);
                break;
            case ResponseEventError.MavlinkId when frame.TryDecode(out ResponseEventError error):
                if (error.TargetSystem == _own.SystemId && error.TargetComponent == _own.ComponentId)
                    Take(error, now);
                break;
            default:
                break;
        }
    }

    /// <summary>Takes out the next event.</summary>
    /// <param name="happened">The event.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTake(out MavlinkEvent happened)
    {
        happened = default;
        if (_waitingCount == 0)
            return false;
        happened = _waiting[_firstWaiting];
        _firstWaiting = (_firstWaiting + 1) % MaxWaiting;
        _waitingCount--;
        return true;
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        while (_hasBegun && _settled != ulong.MaxValue && now >= _due)
        {
            (int oldest, int newest) = OldestGap();
            var first = (ushort)(_highest - oldest);
            if (first != _asked)
                (_asked, _tries) = (first, 0);
            if (_tries++ >= MaxRequests)
            {
                GiveUp(oldest, newest);
                continue;
            }

            _due = now + AnswerTimeout;
            _askedLast = (ushort)(_highest - newest);
            frame = _sender.Create(new RequestEvent
            {
                TargetSystem = _target.SystemId,
                TargetComponent = _target.ComponentId,
                FirstSequence = first,
                LastSequence = _askedLast,
            });
            return true;
        }

        return false;
    }

    private void Take(in Event message, TimeSpan now)
    {
        int ahead = (short)(message.Sequence - _highest);
        if (_hasBegun && IsOfOtherRun(message, ahead))
            _hasBegun = false;
        if (!_hasBegun)
            Begin(message.Sequence, isReceived: false);
        else if (ahead > 0)
            Advance(ahead, now);

        int back = (ushort)(_highest - message.Sequence);
        if (IsSettled(back))
        {
            Repeats++;
            return;
        }

        Settle(back);
        _times[message.Sequence % Window] = message.EventTimeBootMs;
        Received++;
        if (back == 0)
            _newestTime = message.EventTimeBootMs;
        else
            GoOnAsking(now);
        Recovered += back > 0 ? 1 : 0;
        if (_own.IsTargetOf(message.DestinationSystem, message.DestinationComponent))
            Enqueue(new MavlinkEvent(_target, message, back > 0));
    }

    // Numbers that are used again, and times that go back. Nothing keeps so many events that one from before the window
    // could be a copy.
    private bool IsOfOtherRun(in Event message, int ahead)
    {
        if (ahead > 0)
            return message.EventTimeBootMs + (ulong)RestartMilliseconds < _newestTime;
        if (ahead <= -Window)
            return true;
        uint time = _times[message.Sequence % Window];
        return IsSettled(-ahead) && time != NoTime && time != message.EventTimeBootMs;
    }

    // For the next ones once nothing of what was asked for is missing.
    private void GoOnAsking(TimeSpan now)
    {
        _tries = 0;
        int back = (ushort)(_highest - _askedLast);
        _due = back >= Window || OldestGap().Oldest < back ? now : now + AnswerTimeout;
    }

    private void Take(in CurrentEventSequence current, TimeSpan now)
    {
        if ((current.Flags & MavEventCurrentSequenceFlags.Reset) != 0)
            _hasBegun = false;
        if (!_hasBegun)
        {
            // What was before is not asked for.
            Begin(current.Sequence, isReceived: true);
            return;
        }

        int ahead = (short)(current.Sequence - _highest);
        if (ahead > 0)
            Advance(ahead, now);
    }

    // What is older than the oldest that it has is gone.
    private void Take(in ResponseEventError error, TimeSpan now)
    {
        int back = (ushort)(_highest - error.Sequence);
        if (!_hasBegun || back >= Window || IsSettled(back))
            return;
        int gone = (short)(error.SequenceOldestAvailable - error.Sequence);
        int newest = gone > 0 ? Math.Max(0, back - gone + 1) : back;
        GiveUp(back, newest);
        GoOnAsking(now);
    }

    private void Begin(ushort sequence, bool isReceived)
    {
        (_hasBegun, _highest, _tries, _newestTime) = (true, sequence, 0, 0);
        _settled = isReceived ? ulong.MaxValue : ulong.MaxValue - 1;
        for (int i = 0; i < Window; i++)
            _times[i] = NoTime;
    }

    private void Advance(int ahead, TimeSpan now)
    {
        bool wasWhole = _settled == ulong.MaxValue;
        if (ahead >= Window)
        {
            Lost += CountMissing(_settled) + (ahead - Window);
            _settled = 0;
        }
        else
        {
            ulong leaves = _settled >> (Window - ahead);
            Lost += CountMissing(leaves | (ulong.MaxValue << ahead));
            _settled <<= ahead;
        }

        _highest = (ushort)(_highest + ahead);
        if (wasWhole)
            (_due, _tries) = (now + ReorderTime, 0);
    }

    // -1 where nothing is missing.
    private (int Oldest, int Newest) OldestGap()
    {
        int oldest = Window - 1;
        while (oldest >= 0 && IsSettled(oldest))
            oldest--;
        int newest = oldest;
        while (newest > 0 && !IsSettled(newest - 1))
            newest--;
        return (oldest, newest);
    }

    private void GiveUp(int oldest, int newest)
    {
        for (int back = oldest; back >= newest; back--)
        {
            if (IsSettled(back))
                continue;
            Settle(back);
            Lost++;
            _times[(ushort)(_highest - back) % Window] = NoTime;
        }
    }

    private bool IsSettled(int back) => (_settled & (1UL << back)) != 0;

    private void Settle(int back) => _settled |= 1UL << back;

    private static int CountMissing(ulong settled)
    {
        int missing = 0;
        for (ulong rest = ~settled; rest != 0; rest &= rest - 1)
            missing++;
        return missing;
    }

    private void Enqueue(in MavlinkEvent happened)
    {
        if (_waitingCount == MaxWaiting)
        {
            _firstWaiting = (_firstWaiting + 1) % MaxWaiting;
            _waitingCount--;
            Dropped++;
        }

        _waiting[(_firstWaiting + _waitingCount++) % MaxWaiting] = happened;
    }
}
