using System;
using System.Collections.Generic;
using Rabit.Links;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// A frame reader for each peer of a link: the bytes of each are a stream of their own, so that a frame that one cuts
/// is not mixed with another's, and a false header of one holds back no other. Knows when a reader that holds bytes
/// back is to be flushed. Allocates only for a peer with a new number. The reader's thread only.
/// </summary>
/// <param name="dialect">The messages that are checked.</param>
/// <param name="flushAfter">After what silence of a peer what is held back of it is searched for frames.</param>
internal sealed class PeerFrames(MavlinkDialect dialect, TimeSpan flushAfter)
{
    private readonly List<MavlinkFrameReader> _readers = [new(dialect)];
    private readonly List<TimeSpan> _lastBytes = [TimeSpan.Zero];

    public long SkippedBytes
    {
        get
        {
            long skipped = 0;
            foreach (MavlinkFrameReader reader in _readers)
                skipped += reader.Counters.SkippedBytes;
            return skipped;
        }
    }

    public long IncompatibleFrames
    {
        get
        {
            long frames = 0;
            foreach (MavlinkFrameReader reader in _readers)
                frames += reader.Counters.IncompatibleFrames;
            return frames;
        }
    }

    /// <summary>The reader for bytes that came now.</summary>
    public MavlinkFrameReader Of(LinkRead read, TimeSpan now)
    {
        while (read.Peer >= _readers.Count)
        {
            _readers.Add(new MavlinkFrameReader(dialect));
            _lastBytes.Add(TimeSpan.Zero);
        }

        _lastBytes[read.Peer] = now;
        return _readers[read.Peer];
    }

    /// <summary>When the next reader is to be flushed; the longest time where none holds anything back.</summary>
    public TimeSpan NextFlush
    {
        get
        {
            TimeSpan next = TimeSpan.MaxValue;
            for (int peer = 0; peer < _readers.Count; peer++)
            {
                if (_readers[peer].PendingBytes > 0 && _lastBytes[peer] + flushAfter < next)
                    next = _lastBytes[peer] + flushAfter;
            }

            return next;
        }
    }

    /// <summary>Takes the next frame from what is held back of peers that are silent.</summary>
    /// <returns>False where there is none.</returns>
    public bool TryFlush(TimeSpan now, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        for (int peer = 0; peer < _readers.Count; peer++)
        {
            bool isDue = _readers[peer].PendingBytes > 0
                && (now == TimeSpan.MaxValue || _lastBytes[peer] + flushAfter <= now);
            if (isDue && _readers[peer].TryFlush(out frame, out info))
                return true;
        }

        frame = default;
        info = default;
        return false;
    }
}
