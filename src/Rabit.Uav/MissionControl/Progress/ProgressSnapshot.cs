using System;
using System.Collections.Immutable;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What is to be written to the progress file. Filled by the manager, read by the writer's thread, and used again:
/// while <see cref="IsFree"/> is false it is the writer's.
/// </summary>
[HandedOver]
internal sealed class ProgressSnapshot
{
    // Set to false by the manager before it hands the snapshot over, to true by the writer after it has written it.
    private volatile bool _isFree = true;

    public bool IsFree
    {
        get => _isFree;
        set => _isFree = value;
    }

    public string MissionName { get; set; } = string.Empty;

    public string Fingerprint { get; set; } = string.Empty;

    public DateTimeOffset SavedUtc { get; set; }

    public MissionPhase Phase { get; set; }

    public bool IsCommanding { get; set; }

    public bool IsInAir { get; set; }

    public GeodeticPosition Home { get; set; }

    public ImmutableArray<LaneSegment> Legs { get; set; } = [];

    public int LanesFlown { get; set; }

    public ImmutableArray<SkippedLane> Skipped { get; set; } = [];

    public ProgressChanges Changes { get; set; } = ProgressChanges.None;

    public double FlownMetresOfLeg { get; set; }

    public int GapPasses { get; set; }

    public double Coverage { get; set; }

    public CoverageCells Cells { get; set; } = CoverageCells.None;

    public TrackList Tracks { get; set; } = TrackList.None;

    public ImmutableArray<int> Revisited { get; set; } = [];

    /// <summary>Those of the flights before.</summary>
    public ImmutableArray<MissionProgressTarget> Earlier { get; set; } = [];

    /// <summary>Those that the operator rejected on the flights before.</summary>
    public ImmutableArray<MissionProgressTarget> EarlierRejected { get; set; } = [];
}
