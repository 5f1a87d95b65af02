using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>
/// What of others is to be sent on. Each datagram once over each open link, after a short wait that differs between
/// vehicles, so that two of them do not speak at once; again only when its sender sends it again. A link without room
/// has it when it has some, unless the datagram is too old by then. Bounded. One thread.
/// </summary>
/// <param name="random">The waits.</param>
/// <param name="roomFor">Over which links a datagram of a class goes now.</param>
internal sealed class ExchangeRelay(ExchangeRandom random, Func<VehicleMessageClass, LinkRoom> roomFor)
{
    private const int MaxWaiting = 64;
    private const int MaxKnown = 1024;

    // Shorter than any time-out of a sender, longer than the ways that a copy may take.
    private static readonly TimeSpan Known = TimeSpan.FromTicks(300 * TimeSpan.TicksPerMillisecond);

    // Acknowledgements and announcements, which have no lifetime, are sent again by then.
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(2);

    private const int MinWaitMs = 5;
    private const int MaxWaitMs = 40;

    private readonly Dictionary<long, TimeSpan> _known = [];
    private readonly List<long> _old = [];
    private readonly List<Waiting> _waiting = [];

    /// <summary>Copies that links without room did not get, while others did.</summary>
    public long CopiesHeldBack { get; private set; }

    /// <summary>When the next one is due, and what was due already may have room.</summary>
    public TimeSpan NextDue(TimeSpan now)
    {
        TimeSpan due = TimeSpan.MaxValue;
        foreach (Waiting waiting in _waiting)
        {
            LinkRoom room = roomFor(waiting.Class);
            bool isHeldUp = waiting.Due <= now && room.Left(waiting.Carried) == 0;
            TimeSpan next = isHeldUp ? now + room.Wait : waiting.Due;
            if (next < due)
                due = next;
        }

        return due;
    }

    /// <returns>False where it was sent on a moment ago, or there is no room.</returns>
    public bool Add(
        long key, ReadOnlySpan<byte> datagram, byte hops, ExchangeKind kind, VehicleMessageClass messageClass,
        TimeSpan now)
    {
        if (_known.TryGetValue(key, out TimeSpan last) && now - last < Known)
            return false;

        // One that its sender sends again while the first still waits takes that one's place.
        int same = _waiting.FindIndex(w => w.Key == key);
        if (same < 0 && _waiting.Count == MaxWaiting && !MakeRoom())
            return false;
        if (_known.Count == MaxKnown)
            Forget(now);
        _known[key] = now;
        byte[] copy = datagram.ToArray();
        copy[ExchangeWire.HopsOffset(kind)] = hops;
        int waitMs = MinWaitMs + random.Next(MaxWaitMs - MinWaitMs + 1);
        var waiting = new Waiting
        {
            Key = key,
            Bytes = copy,
            Kind = kind,
            Class = messageClass,
            CameAt = now,
            Due = now + TimeSpan.FromTicks(waitMs * TimeSpan.TicksPerMillisecond),
        };
        if (same < 0)
            _waiting.Add(waiting);
        else
            _waiting[same] = waiting;
        return true;
    }

    /// <summary>Writes the next one that is due where a link has room for it; what is too old is dropped.</summary>
    /// <param name="now">The time.</param>
    /// <param name="isCopy">Whether one that went over another link before is asked for, or one that did not.</param>
    /// <param name="to">Where it goes.</param>
    /// <param name="datagram">Its length, and over which links.</param>
    public bool TryTake(TimeSpan now, bool isCopy, Span<byte> to, out ExchangeDatagram datagram)
    {
        datagram = default;
        for (int i = 0; i < _waiting.Count; i++)
        {
            Waiting waiting = _waiting[i];
            if (waiting.Due > now || (waiting.Carried != 0) != isCopy)
                continue;
            LinkRoom room = roomFor(waiting.Class);
            if (room.IsCarried(waiting.Carried) || !TryWrite(waiting, now, to))
            {
                End(i--, room);
                continue;
            }

            ulong links = room.Left(waiting.Carried);
            if (links == 0)
                continue;
            datagram = new ExchangeDatagram { Length = waiting.Bytes.Length, Class = waiting.Class, Links = links };
            waiting.Carried |= links;
            if (room.IsCarried(waiting.Carried))
                _waiting.RemoveAt(i);
            return true;
        }

        return false;
    }

    // False where it is too old.
    private static bool TryWrite(Waiting waiting, TimeSpan now, Span<byte> to)
    {
        waiting.Bytes.CopyTo(to);
        TimeSpan waited = now - waiting.CameAt;
        return waiting.Kind == ExchangeKind.Fragment ? ExchangeWire.TryAge(to, waited) : waited <= MaxWait;
    }

    private void End(int index, LinkRoom room)
    {
        if (_waiting[index].Carried != 0)
            CopiesHeldBack += room.Missed(_waiting[index].Carried);
        _waiting.RemoveAt(index);
    }

    // The oldest that went over a link already gives way: one link must not keep what is new from the others.
    private bool MakeRoom()
    {
        int index = _waiting.FindIndex(w => w.Carried != 0);
        if (index < 0)
            return false;
        End(index, roomFor(_waiting[index].Class));
        return true;
    }

    private void Forget(TimeSpan now)
    {
        _old.Clear();
        foreach (KeyValuePair<long, TimeSpan> known in _known)
        {
            if (now - known.Value >= Known)
                _old.Add(known.Key);
        }

        foreach (long key in _old)
            _known.Remove(key);
        if (_known.Count == MaxKnown)
            _known.Clear();
    }

    private sealed class Waiting
    {
        public long Key { get; init; }

        public byte[] Bytes { get; init; } = [];

        public ExchangeKind Kind { get; init; }

        public VehicleMessageClass Class { get; init; }

        public TimeSpan CameAt { get; init; }

        public TimeSpan Due { get; init; }

        /// <summary>The links that it went over.</summary>
        public ulong Carried { get; set; }
    }
}
