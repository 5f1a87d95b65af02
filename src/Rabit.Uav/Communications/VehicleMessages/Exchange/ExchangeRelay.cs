using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>
/// What of others is to be sent on. Each datagram once, after a short wait that differs between vehicles, so that two
/// of
/// them do not speak at once; again only when its sender sends it again. Bounded. One thread.
/// </summary>
internal sealed class ExchangeRelay(ExchangeRandom random)
{
    private const int MaxWaiting = 64;
    private const int MaxKnown = 1024;

    // Shorter than any time-out of a sender, longer than the ways that a copy may take.
    private static readonly TimeSpan Known = TimeSpan.FromTicks(300 * TimeSpan.TicksPerMillisecond);
    private const int MinWaitMs = 5;
    private const int MaxWaitMs = 40;

    private readonly Dictionary<long, TimeSpan> _known = [];
    private readonly List<long> _old = [];
    private readonly List<Waiting> _waiting = [];

    public TimeSpan NextDue
    {
        get
        {
            TimeSpan due = TimeSpan.MaxValue;
            foreach (Waiting waiting in _waiting)
            {
                if (waiting.Due < due)
                    due = waiting.Due;
            }

            return due;
        }
    }

    /// <returns>False where it was sent on a moment ago, or there is no room.</returns>
    public bool Add(
        long key, ReadOnlySpan<byte> datagram, byte hops, ExchangeKind kind, VehicleMessageClass messageClass,
        TimeSpan now)
    {
        if ((_known.TryGetValue(key, out TimeSpan last) && now - last < Known) || _waiting.Count == MaxWaiting)
            return false;
        if (_known.Count == MaxKnown)
            Forget(now);
        _known[key] = now;
        byte[] copy = datagram.ToArray();
        copy[ExchangeWire.HopsOffset(kind)] = hops;
        int waitMs = MinWaitMs + random.Next(MaxWaitMs - MinWaitMs + 1);
        _waiting.Add(new Waiting
        {
            Bytes = copy,
            Kind = kind,
            Class = messageClass,
            CameAt = now,
            Due = now + TimeSpan.FromTicks(waitMs * TimeSpan.TicksPerMillisecond),
        });
        return true;
    }

    /// <summary>Writes the next one that is due; a fragment whose life ended meanwhile is dropped.</summary>
    public bool TryTake(TimeSpan now, Span<byte> to, out ExchangeDatagram datagram)
    {
        datagram = default;
        for (int i = 0; i < _waiting.Count; i++)
        {
            Waiting waiting = _waiting[i];
            if (waiting.Due > now)
                continue;
            _waiting.RemoveAt(i--);
            if (waiting.Kind == ExchangeKind.Fragment && !ExchangeWire.TryAge(waiting.Bytes, now - waiting.CameAt))
                continue;
            waiting.Bytes.CopyTo(to);
            datagram = new ExchangeDatagram { Length = waiting.Bytes.Length, Class = waiting.Class };
            return true;
        }

        return false;
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
        public byte[] Bytes { get; init; } = [];

        public ExchangeKind Kind { get; init; }

        public VehicleMessageClass Class { get; init; }

        public TimeSpan CameAt { get; init; }

        public TimeSpan Due { get; init; }
    }
}
