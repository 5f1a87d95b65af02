using System.Collections.Immutable;

namespace Rabit.Uav.Messages;

/// <summary>
/// Who of a group flies which lanes: what one vehicle, the author, decided for those that it receives. A plain value;
/// the shares are immutable, and copies share them.
/// </summary>
public struct LaneDivision
{
    /// <summary>The most vehicles that a group has.</summary>
    public const int MaxShares = 16;

    private ImmutableArray<LaneShare> _shares;

    /// <summary>Identifies the lanes: <see cref="GroupReport.LanesKey"/>.</summary>
    public uint LanesKey { get; set; }

    /// <summary>Grows with each division of its author, modulo 2^16.</summary>
    public ushort Number { get; set; }

    /// <summary>The shares, at most <see cref="MaxShares"/>; never default.</summary>
    public ImmutableArray<LaneShare> Shares
    {
        readonly get => _shares.IsDefault ? [] : _shares;
        set => _shares = value;
    }
}
