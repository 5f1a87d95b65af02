using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Rabit.Links.Tests;

/// <summary>Reads a link on a thread of its own, as a program does, until it ends.</summary>
internal sealed class LinkCollector
{
    private readonly object _gate = new();
    private readonly List<byte> _bytes = new();
    private readonly AutoResetEvent _readable = new(false);
    private readonly IByteLink _link;
    private readonly byte[] _buffer;
    private LinkRead _end;
    private Exception? _fault;
    private bool _done;

    public LinkCollector(IByteLink link, int bufferBytes = 4096)
    {
        _link = link;
        _buffer = new byte[bufferBytes];
        link.SetReadableCallback(() => _readable.Set());
        new Thread(Run) { IsBackground = true, Name = $"reads {link.Url}" }.Start();
    }

    /// <summary>Waits for the next bytes.</summary>
    public byte[] Take(int count)
    {
        lock (_gate)
        {
            Await(() => _bytes.Count >= count || _done, LinkTestBed.TestTimeout);
            if (_bytes.Count < count)
                throw new InvalidOperationException($"{_bytes.Count} of {count} bytes came; {_end}", _fault);
            byte[] taken = _bytes.Take(count).ToArray();
            _bytes.RemoveRange(0, count);
            return taken;
        }
    }

    /// <summary>Waits for the end of the link.</summary>
    public LinkRead WaitForEnd()
    {
        if (!EndsWithin(LinkTestBed.TestTimeout)) throw new TimeoutException($"{_link.Url} did not end");
        return _fault is null ? _end : throw new InvalidOperationException("the link threw", _fault);
    }

    /// <summary>Whether the link ends in a given time.</summary>
    public bool EndsWithin(TimeSpan limit)
    {
        lock (_gate) return Await(() => _done, limit);
    }

    private void Run()
    {
        try
        {
            while (ReadOnce())
            {
            }
        }
        catch (Exception e)
        {
            _fault = e;
        }

        lock (_gate)
        {
            _done = true;
            Monitor.PulseAll(_gate);
        }
    }

    private bool ReadOnce()
    {
        LinkRead read = _link.Read(_buffer);
        if (read.Kind == LinkReadKind.NothingYet)
        {
            _readable.WaitOne(read.RetryAfter ?? Timeout.InfiniteTimeSpan);
            return true;
        }

        _end = read;
        if (read.Kind == LinkReadKind.Ended) return false;
        lock (_gate)
        {
            _bytes.AddRange(_buffer.Take(read.Count));
            Monitor.PulseAll(_gate);
        }

        return true;
    }

    private bool Await(Func<bool> condition, TimeSpan limit)
    {
        DateTime deadline = DateTime.UtcNow + limit;
        while (!condition())
        {
            TimeSpan left = deadline - DateTime.UtcNow;
            if (left <= TimeSpan.Zero || !Monitor.Wait(_gate, left)) return condition();
        }

        return true;
    }
}
