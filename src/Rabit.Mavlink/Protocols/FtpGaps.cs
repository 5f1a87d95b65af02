using System.Collections.Generic;

namespace Rabit.Mavlink.Protocols;

/// <summary>What is missing of a file: ranges of bytes, in order, that do not touch.</summary>
internal sealed class FtpGaps
{
    private readonly List<(long From, long To)> _gaps = [];

    public bool IsEmpty => _gaps.Count == 0;

    /// <summary>The first one; only where there is one.</summary>
    public (long From, long To) First => _gaps[0];

    public long Bytes
    {
        get
        {
            long bytes = 0;
            foreach ((long from, long to) in _gaps)
                bytes += to - from;
            return bytes;
        }
    }

    /// <summary>All of a file is missing.</summary>
    public void Reset(long length)
    {
        _gaps.Clear();
        if (length > 0)
            _gaps.Add((0, length));
    }

    /// <summary>Bytes are there.</summary>
    /// <returns>Whether one of them was missing.</returns>
    public bool Fill(long start, long end)
    {
        bool isNew = false;
        for (int i = _gaps.Count - 1; i >= 0; i--)
        {
            (long from, long to) = _gaps[i];
            if (to <= start || from >= end)
                continue;
            isNew = true;
            _gaps.RemoveAt(i);
            if (to > end)
                _gaps.Insert(i, (end, to));
            if (from < start)
                _gaps.Insert(i, (from, start));
        }

        return isNew;
    }
}
