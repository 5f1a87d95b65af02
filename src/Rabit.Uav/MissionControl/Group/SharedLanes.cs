using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The lanes that the vehicles of a group share, which parts of them were seen, by us or by others, and which are left
/// out at the operator's command, whichever vehicle it was for. One thread.
/// </summary>
internal sealed class SharedLanes
{
    private const int Parts = LaneCoverage.PartsPerLane;
    private const ushort AllParts = ushort.MaxValue;

    // As the coverage that a mission requires: a few cells at the border are left by rounding.
    private const double MaxUnseenFraction = 0.02;

    // A leg that is left out lies on its lane.
    private const double OnLaneMetres = 1;

    private readonly ushort[] _seen;
    private readonly ushort[] _skipped;
    private readonly double _halfMetres;

    /// <param name="key">Identifies them.</param>
    /// <param name="lanes">In the frame of the plan.</param>
    /// <param name="spacingMetres">From one to the next.</param>
    public SharedLanes(uint key, IReadOnlyList<LaneSegment> lanes, double spacingMetres)
    {
        (Key, Lanes, _halfMetres) = (key, lanes, spacingMetres / 2);
        (_seen, _skipped) = (new ushort[lanes.Count], new ushort[lanes.Count]);
        MetresLeft = new double[lanes.Count];
        for (int i = 0; i < lanes.Count; i++)
            MetresLeft[i] = lanes[i].Length;
    }

    public uint Key { get; }

    public IReadOnlyList<LaneSegment> Lanes { get; }

    /// <summary>What is left of each lane; filled here.</summary>
    public double[] MetresLeft { get; }

    /// <summary>How often another part was seen, or left out.</summary>
    public int Changes { get; private set; }

    /// <summary>How many parts are left out.</summary>
    public int Skips { get; private set; }

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
            bool isNew = (_seen[lane] & (1 << part)) == 0;
            if (isNew && coverage.IsSeen(PartsOf(lane, part, 1), _halfMetres, MaxUnseenFraction))
                SetSeen(lane, part);
        }
    }

    /// <summary>Takes what others have seen; it counts as seen here, too.</summary>
    /// <returns>False where it is not of these lanes.</returns>
    public bool Take(in LaneCoverage received, CoverageGrid coverage)
    {
        ImmutableArray<ushort> parts = received.Parts;
        if (!IsOfThese(received))
            return false;
        for (int i = 0; i < parts.Length; i++)
        {
            int lane = received.FirstLane + i;
            for (int part = 0; part < Parts; part++)
            {
                if ((parts[i] & ~_seen[lane] & (1 << part)) == 0)
                    continue;
                SetSeen(lane, part);
                Mark(PartsOf(lane, part, 1), coverage);
            }
        }

        return true;
    }

    /// <summary>Takes what others leave out.</summary>
    /// <returns>What of it was not known, in runs of parts; none where it is not of these lanes.</returns>
    public IReadOnlyList<SkippedLane> TakeSkipped(in LaneCoverage received)
    {
        var added = new List<SkippedLane>();
        for (int i = 0; i < received.Skipped.Length && IsOfThese(received); i++)
        {
            int lane = received.FirstLane + i;
            for (int part = 0; part < Parts; part++)
            {
                int first = part;
                for (; part < Parts && (received.Skipped[i] & ~_skipped[lane] & (1 << part)) != 0; part++)
                    SetSkipped(lane, part);
                if (part > first)
                    added.Add(new SkippedLane(PartsOf(lane, first, part - first), _halfMetres));
            }
        }

        return added;
    }

    /// <summary>A leg that we leave out: the parts of lanes on it are left out for all.</summary>
    public void Skip(LaneSegment leg)
    {
        for (int lane = 0; lane < Lanes.Count; lane++)
        {
            for (int part = 0; part < Parts; part++)
            {
                bool isNew = ((_seen[lane] | _skipped[lane]) & (1 << part)) == 0;
                if (isNew && IsOn(leg, PartsOf(lane, part, 1)))
                    SetSkipped(lane, part);
            }
        }
    }

    /// <summary>What was seen of some lanes.</summary>
    /// <param name="first">The first of them.</param>
    public LaneCoverage ToMessage(int first)
    {
        int count = Math.Min(LaneCoverage.MaxLanes, _seen.Length - first);
        return new LaneCoverage
        {
            LanesKey = Key,
            FirstLane = first,
            Parts = ImmutableArray.Create(_seen, first, count),
            Skipped = _skipped.Skip(first).Take(count).Any(s => s != 0)
                ? ImmutableArray.Create(_skipped, first, count)
                : [],
        };
    }

    private bool IsOfThese(in LaneCoverage received)
        => received.LanesKey == Key && received.FirstLane + received.Parts.Length <= Lanes.Count;

    private static bool IsOn(LaneSegment leg, LaneSegment part)
    {
        PlanePoint along = part.End - part.Start;
        return leg.DistanceTo(part.Start + (0.1 * along)) <= OnLaneMetres
            || leg.DistanceTo(part.Start + (0.5 * along)) <= OnLaneMetres
            || leg.DistanceTo(part.Start + (0.9 * along)) <= OnLaneMetres;
    }

    private void SetSeen(int lane, int part)
    {
        _seen[lane] |= (ushort)(1 << part);
        CountLeft(lane);
    }

    private void SetSkipped(int lane, int part)
    {
        _skipped[lane] |= (ushort)(1 << part);
        Skips++;
        CountLeft(lane);
    }

    private void CountLeft(int lane)
    {
        int left = 0;
        for (int part = 0; part < Parts; part++)
            left += ((_seen[lane] | _skipped[lane]) >> part & 1) == 0 ? 1 : 0;
        MetresLeft[lane] = left * Lanes[lane].Length / Parts;
        Changes++;
    }

    private void Mark(LaneSegment middle, CoverageGrid coverage)
    {
        PlanePoint along = (1 / middle.Length) * (middle.End - middle.Start);
        PlanePoint right = _halfMetres * new PlanePoint(-along.East, along.North);
        coverage.Mark(middle.Start - right, middle.End - right, middle.End + right, middle.Start + right);
    }

    private LaneSegment PartsOf(int lane, int first, int count)
    {
        LaneSegment all = Lanes[lane];
        PlanePoint step = (1.0 / Parts) * (all.End - all.Start);
        return new LaneSegment(all.Start + (first * step), all.Start + ((first + count) * step));
    }
}
