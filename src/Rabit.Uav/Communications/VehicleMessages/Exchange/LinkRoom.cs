using System;

namespace Rabit.Uav.Communications;

/// <summary>Over which links a datagram is to go, a bit for each. A plain value.</summary>
/// <param name="Wanted">Those that lead there and are open.</param>
/// <param name="Free">Those of them with room now.</param>
internal readonly record struct LinkRoom(ulong Wanted, ulong Free)
{
    /// <summary>Of one link with room.</summary>
    public static LinkRoom Always { get; } = new(1, 1);

    /// <summary>How long until one of the others may have room; zero where that is not known.</summary>
    public TimeSpan Wait { get; init; }

    /// <summary>The links that have room and did not carry it yet.</summary>
    public ulong Left(ulong carried) => Free & ~carried;

    /// <summary>Whether each link has carried it.</summary>
    public bool IsCarried(ulong carried) => carried != 0 && (Wanted & ~carried) == 0;

    /// <summary>How many links did not carry it.</summary>
    public int Missed(ulong carried)
    {
        int links = 0;
        for (ulong missed = Wanted & ~carried; missed != 0; missed &= missed - 1)
            links++;
        return links;
    }
}
