using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core;

/// <summary>How long the units of work of one manager are modelled to take: the usual duration, and single longer ones.</summary>
internal sealed class UnitOfWorkDurations
{
    // By time; the next one last.
    private readonly List<(TimeSpan At, TimeSpan Duration)> _single = [];

    public TimeSpan Usual { get; set; }

    public TimeSpan Longest => _single.Select(s => s.Duration).Append(Usual).Max();

    public void Add(TimeSpan at, TimeSpan duration)
    {
        int index = _single.FindIndex(s => s.At <= at);
        _single.Insert(index < 0 ? _single.Count : index, (at, duration));
    }

    public TimeSpan TakeNext(TimeSpan now)
    {
        int last = _single.Count - 1;
        if (last < 0 || _single[last].At > now)
            return Usual;
        TimeSpan duration = _single[last].Duration;
        _single.RemoveAt(last);
        return duration;
    }
}
