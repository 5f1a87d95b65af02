using System;
using System.Collections.Generic;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>What one look at a reactor has shown. One thread.</summary>
internal sealed class ReactorLook
{
    private readonly List<string> _reasons = [];
    private readonly Dictionary<string, object> _data = new(StringComparer.Ordinal);
    private int _managers;

    public ReactorCondition Condition { get; private set; }

    /// <summary>MANAGER.state, .runs, .faults, .restarts, .hangs and .missedDeadlines of each manager.</summary>
    public IReadOnlyDictionary<string, object> Data => _data;

    /// <summary>What the reactor does, in its own words; null where it says nothing.</summary>
    public string? Description { get; set; }

    /// <summary>For the one line of a service manager.</summary>
    public string StatusLine => Description is null ? ToString() : $"{Description}; {this}";

    public void Add(ReactorCondition condition, string reason)
    {
        _reasons.Add(reason);
        if (condition > Condition)
            Condition = condition;
    }

    public void Put(string manager, in ManagerStatus status)
    {
        _managers++;
        _data[manager + ".state"] = status.State.ToString();
        _data[manager + ".runs"] = status.Runs;
        _data[manager + ".faults"] = status.Faults;
        _data[manager + ".restarts"] = status.Restarts;
        _data[manager + ".hangs"] = status.Hangs;
        _data[manager + ".missedDeadlines"] = status.MissedDeadlines;
    }

    public override string ToString()
        => _reasons.Count > 0
            ? string.Join("; ", _reasons)
            : FormattableString.Invariant($"{_managers} managers run");
}
