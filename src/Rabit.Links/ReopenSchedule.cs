using System;

namespace Rabit.Links;

/// <summary>
/// When a link is tried again: a delay that doubles with every failure in a row. A row ends when bytes came, or when
/// the link stayed open for the longest delay: a server that takes every connection and closes it at once is a failure
/// too. Used by the thread that reads.
/// </summary>
internal sealed class ReopenSchedule(LinkOptions options)
{
    private TimeSpan _delay;
    private long _since; // the last failure
    private long _openedAt;
    private int _failures;

    /// <summary>How long to wait before the next try; zero or less for now.</summary>
    public TimeSpan Left => _failures == 0 ? TimeSpan.Zero : _delay - options.Clock.GetElapsedTime(_since);

    public void Opened() => _openedAt = options.Clock.GetTimestamp();

    public void Received() => _failures = 0;

    public void Lost()
    {
        if (options.Clock.GetElapsedTime(_openedAt) >= options.MaxReopenDelay) _failures = 0;
        Failed();
    }

    public void Failed()
    {
        _delay = _failures == 0 ? options.FirstReopenDelay : _delay + _delay;
        if (_delay > options.MaxReopenDelay) _delay = options.MaxReopenDelay;
        _failures++;
        _since = options.Clock.GetTimestamp();
    }
}
