using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// Recognises messages that came a moment ago, over another link or by a detour. Only for a while: a vehicle that was
/// restarted may use its numbers again. Bounded; allocates nothing.
/// </summary>
internal sealed class RecentVehicleMessages
{
    /// <summary>How long a message is known again: several times the way through the slowest net.</summary>
    public static readonly TimeSpan Window = TimeSpan.FromSeconds(10);

    // Ten seconds of ten a second from five vehicles; scanned from the newest, which is where a duplicate is.
    private const int Capacity = 512;

    private readonly (byte Source, long Identity, TimeSpan Time)[] _entries = new (byte, long, TimeSpan)[Capacity];
    private int _count;
    private int _next;

    public bool IsNew(byte source, long identity, TimeSpan now)
    {
        for (int back = 1; back <= _count; back++)
        {
            ref readonly (byte Source, long Identity, TimeSpan Time) entry =
                ref _entries[(_next + Capacity - back) % Capacity];
            if (now - entry.Time > Window)
                break;
            if (entry.Source == source && entry.Identity == identity)
                return false;
        }

        _entries[_next] = (source, identity, now);
        _next = (_next + 1) % Capacity;
        if (_count < Capacity)
            _count++;
        return true;
    }
}
