using System.Collections.Immutable;

namespace Rabit.Uav.Messages;

/// <summary>
/// Which parts of the lanes of a group were seen, and which are left out at the operator's command, by the sender or by
/// those whose coverage it has received. A plain value; the parts are immutable, and copies share them.
/// </summary>
public struct LaneCoverage
{
    /// <summary>In so many equal parts each lane is divided.</summary>
    public const int PartsPerLane = 16;

    /// <summary>The most lanes that one message describes.</summary>
    public const int MaxLanes = 64;

    private ImmutableArray<ushort> _parts;
    private ImmutableArray<ushort> _skipped;

    /// <summary>Identifies the lanes: <see cref="GroupReport.LanesKey"/>.</summary>
    public uint LanesKey { get; set; }

    /// <summary>The first lane that it describes, from 0.</summary>
    public int FirstLane { get; set; }

    /// <summary>
    /// For each lane one bit for each part that was seen, from the lane's start on; at most <see cref="MaxLanes"/>;
    /// never default.
    /// </summary>
    public ImmutableArray<ushort> Parts
    {
        readonly get => _parts.IsDefault ? [] : _parts;
        set => _parts = value;
    }
    /// <summary>
    /// For each lane one bit for each part that is left out: no vehicle flies it. As many as <see cref="Parts"/>, or
    /// none where nothing is left out; never default.
    /// </summary>
    public ImmutableArray<ushort> Skipped
    {
        readonly get => _skipped.IsDefault ? [] : _skipped;
        set => _skipped = value;
    }
}
