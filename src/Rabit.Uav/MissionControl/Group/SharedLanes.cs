using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The lanes that the vehicles of a group share, and which parts of them were seen, by us or by others. One thread.
/// </summary>
internal sealed class SharedLanes
{
    private const int Parts = LaneCoverage.PartsPerLane;
    private const ushort AllParts = ushort.MaxValue;

    // As the coverage that a mission requires: a few cells at the border are left by rounding.
    private const double MaxUnseenFraction = 0.02;

    private readonly ushort[] _seen;
    private readonly double _halfMetres;

    /// <param name="key">Identifies them.</param>
    /// <param name="lanes">In the frame of the plan.</param>
    /// <param name="spacingMetres">From one to the next.</param>
    public SharedLanes(uint key, IReadOnlyList<LaneSegment> lanes, double spacingMetres)
    {
        (Key, Lanes, _halfMetres) = (key, lanes, spacingMetres / 2);
        _seen = new ushort[lanes.Count];
        MetresLeft = new double[lanes.Count];
        for (int i = 0; i < lanes.Count; i++)
            MetresLeft[i] = lanes[i].Length;
    }

    public uint Key { get; }

    public IReadOnlyList<LaneSegment> Lanes { get; }

    /// <summary>What is left of each lane; filled here.</summary>
    public double[] MetresLeft { get; }

    /// <summary>How often another part was seen.</summary>
    public int Changes { get; private set; }

    /// <summary>The lanes of a share; one that does not fit the lanes has none.</summary>
    public IReadOnlyList<LaneSegment> Of(LaneShare share)
    {
        var lanes = new List<LaneSegment>(share.Count);
        for (int i = share.First; i < share.First + share.Count && i < Lanes.Count; i++)
            lanes.Add(Lanes[i]);
        return lanes;
    }

    /// <summary>Whether a place is beside a lane of a share.</summary>
    public bool IsBeside(LaneShare share, PlanePoint place, double marginMetres)
    {
        for (int i = share.First; i < share.First + share.Count && i < Lanes.Count; i++)
        {
            if (Lanes[i].DistanceTo(place) <= _halfMetres + marginMetres)
                return true;
        }

        return false;
    }

    /// <summary>Takes over what our own camera has seen of a lane.</summary>
    public void Take(int lane, CoverageGrid coverage)
    {
        for (int part = 0; part < Parts && _seen[lane] != AllParts; part++)
        {
            if ((_seen[lane] & (1 << part)) != 0)
                continue;
            (int places, int unseen) = coverage.Count(PartOf(lane, part), _halfMetres);
            if (unseen <= MaxUnseenFraction * places)
                SetSeen(lane, part);
        }
    }

    /// <summary>Takes what others have seen; it counts as seen here, too.</summary>
    /// <returns>False where it is not of these lanes.</returns>
    public bool Take(in LaneCoverage received, CoverageGrid coverage)
    {
        ImmutableArray<ushort> parts = received.Parts;
        if (received.LanesKey != Key || received.FirstLane + parts.Length > Lanes.Count)
            return false;
        for (int i = 0; i < parts.Length; i++)
        {
            int lane = received.FirstLane + i;
            for (int part = 0; part < Parts; part++)
            {
                if ((parts[i] & ~_seen[lane] & (1 << part)) == 0)
                    continue;
                SetSeen(lane, part);
                Mark(PartOf(lane, part), coverage);
            }
        }

        return true;
    }

    /// <summary>What was seen of some lanes.</summary>
    /// <param name="first">The first of them.</param>
    public LaneCoverage ToMessage(int first) => new()
    {
        LanesKey = Key,
        FirstLane = first,
        Parts = ImmutableArray.Create(_seen, first, Math.Min(LaneCoverage.MaxLanes, _seen.Length - first)),
    };

    private void SetSeen(int lane, int part)
    {
        _seen[lane] |= (ushort)(1 << part);
        MetresLeft[lane] = _seen[lane] == AllParts
            ? 0
            : MetresLeft[lane] - (Lanes[lane].Length / Parts);
        Changes++;
    }

    private void Mark(LaneSegment middle, CoverageGrid coverage)
    {
        PlanePoint along = (1 / middle.Length) * (middle.End - middle.Start);
        PlanePoint right = _halfMetres * new PlanePoint(-along.East, along.North);
        coverage.Mark(middle.Start - right, middle.End - right, middle.End + right, middle.Start + right);
    }

    private LaneSegment PartOf(int lane, int part)
    {
        LaneSegment all = Lanes[lane];
        PlanePoint step = (1.0 / Parts) * (all.End - all.Start);
        return new LaneSegment(all.Start + (part * step), all.Start + ((part + 1) * step));
    }
}
