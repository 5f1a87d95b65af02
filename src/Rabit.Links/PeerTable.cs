using System;

namespace Rabit.Links;

/// <summary>
/// The peers of a link with many: each has a number, the oldest gives way where there are too many, and one that sends
/// nothing for a while is forgotten. One thread notes, any thread asks; a lock guards all of it.
/// </summary>
/// <typeparam name="TAddress">Compared by <see cref="object.Equals(object)"/>; never changed when here.</typeparam>
internal sealed class PeerTable<TAddress>(LinkLifetime state, TimeSpan idleTime, TimeProvider clock)
    where TAddress : class
{
    /// <summary>How many peers there may be.</summary>
    public const int MaxPeers = 64;

    private readonly object _gate = new();
    private readonly TAddress?[] _addresses = new TAddress?[MaxPeers];
    private readonly long[] _received = new long[MaxPeers];
    private int _last;
    private int _count; // slots in use are below it

    /// <summary>
    /// Notes a sender, which the caller may change later, and gives its number; a new one is copied.
    /// </summary>
    public int Note(TAddress sender, Func<TAddress, TAddress> copy)
    {
        long now = clock.GetTimestamp();
        lock (_gate)
        {
            int slot = sender.Equals(_addresses[_last]) ? _last : Find(sender);
            if (slot < 0)
            {
                slot = FreeSlot(now);
                _addresses[slot] = copy(sender);
            }

            _received[slot] = now;
            return _last = slot;
        }
    }

    /// <summary>Copies the addresses of all peers.</summary>
    /// <returns>How many.</returns>
    public int CopyTo(TAddress[] addresses)
    {
        int copied = 0;
        lock (_gate)
        {
            ForgetIdle(clock.GetTimestamp());
            for (int slot = 0; slot < _count; slot++)
            {
                if (_addresses[slot] is { } address) addresses[copied++] = address;
            }
        }

        return copied;
    }

    private int Find(TAddress sender)
    {
        for (int slot = 0; slot < _count; slot++)
        {
            if (sender.Equals(_addresses[slot])) return slot;
        }

        return -1;
    }

    private int FreeSlot(long now)
    {
        ForgetIdle(now);
        int oldest = 0;
        for (int slot = 0; slot < MaxPeers; slot++)
        {
            if (_addresses[slot] is null)
            {
                _count = Math.Max(_count, slot + 1);
                return slot;
            }

            if (_received[slot] < _received[oldest]) oldest = slot;
        }

        state.PeerDisplaced();
        return oldest;
    }

    private void ForgetIdle(long now)
    {
        for (int slot = 0; slot < _count; slot++)
        {
            if (_addresses[slot] is null || clock.GetElapsedTime(_received[slot], now) <= idleTime) continue;
            _addresses[slot] = null;
            state.PeerForgotten();
        }
    }
}
