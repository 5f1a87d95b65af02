using System;
using System.Collections.Generic;

namespace Rabit.Mavlink;

/// <summary>
/// Counts frames, gaps and disorder per sender (system, component) of one link. Means something on a direct link only:
/// what a router passes on selectively looks like loss (MAVLink guide, "Packet loss"). Fixed memory; allocates nothing
/// after it was made; one thread at a time.
/// </summary>
public sealed class MavlinkSequenceTracker
{
    private readonly MavlinkSequenceStatistics[] _sources;
    private readonly Dictionary<int, int> _indexBySource;

    /// <summary>Makes a tracker.</summary>
    /// <param name="maxSources">
    /// How many senders it can tell apart, at least 1. Frames of others are counted in <see cref="UntrackedFrames"/>.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">Less than 1.</exception>
    public MavlinkSequenceTracker(int maxSources = 256)
    {
        if (maxSources < 1)
            throw new ArgumentOutOfRangeException(
                nameof(maxSources), maxSources, "A tracker needs room for one sender at least.");
        _sources = new MavlinkSequenceStatistics[maxSources];
        _indexBySource = new Dictionary<int, int>(maxSources);
    }

    /// <summary>How many senders were seen.</summary>
    public int Count => _indexBySource.Count;

    /// <summary>Frames of senders for whom there was no room.</summary>
    public long UntrackedFrames { get; private set; }

    /// <summary>The figures of one sender.</summary>
    /// <param name="index">0 to <see cref="Count"/> - 1, in the order in which they were first seen.</param>
    /// <exception cref="ArgumentOutOfRangeException">No such index.</exception>
    public MavlinkSequenceStatistics this[int index] => (uint)index < (uint)Count
        ? _sources[index]
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"There are {Count} senders.");

    /// <summary>Finds a sender.</summary>
    /// <param name="systemId">Its system id.</param>
    /// <param name="componentId">Its component id.</param>
    /// <param name="statistics">Its figures where it was seen.</param>
    /// <returns>Whether it was seen.</returns>
    public bool TryGet(byte systemId, byte componentId, out MavlinkSequenceStatistics statistics)
    {
        bool isKnown = _indexBySource.TryGetValue(Key(systemId, componentId), out int index);
        statistics = isKnown ? _sources[index] : default;
        return isKnown;
    }

    /// <summary>
    /// Counts a frame, in the order of arrival. Give it checked frames only: the source of an unchecked one is not
    /// certain.
    /// </summary>
    /// <param name="frame">The frame.</param>
    public void Track(in MavlinkFrame frame)
    {
        int key = Key(frame.SystemId, frame.ComponentId);
        if (_indexBySource.TryGetValue(key, out int index))
            _sources[index] = _sources[index].Next(frame.Sequence);
        else if (Count < _sources.Length)
            Add(key, frame);
        else
            UntrackedFrames++;
    }

    private void Add(int key, in MavlinkFrame frame)
    {
        _sources[Count] = new MavlinkSequenceStatistics(frame.SystemId, frame.ComponentId, frame.Sequence);
        _indexBySource.Add(key, Count);
    }

    private static int Key(byte systemId, byte componentId) => (systemId << 8) | componentId;
}
