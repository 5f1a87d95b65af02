using System;
using System.Collections.Generic;

namespace Rabit.Latency.Measuring;

/// <summary>One of those that are set beside each other in a table: a name, and what it does in a round.</summary>
/// <param name="name">The row's name.</param>
/// <param name="round">Measures once and gives the values of the table's columns.</param>
/// <param name="warmUp">What comes before the rounds; null: a round.</param>
internal sealed class Subject(string name, Func<double[]> round, Action? warmUp = null) : IDisposable
{
    private readonly List<IDisposable> _owned = [];

    public string Name => name;

    /// <summary>The columns' values, round by round.</summary>
    public List<Series> Columns { get; } = [];

    /// <summary>What ends with the subject.</summary>
    public Subject Owning(IDisposable owned)
    {
        _owned.Add(owned);
        return this;
    }

    /// <summary>One round that does not count.</summary>
    public void WarmUp()
    {
        if (warmUp is null)
            round();
        else
            warmUp();
    }

    public void Measure()
    {
        double[] values = round();
        while (Columns.Count < values.Length)
            Columns.Add(new Series());
        for (int i = 0; i < values.Length; i++)
            Columns[i].Add(values[i]);
    }

    public void Dispose()
    {
        foreach (IDisposable owned in _owned)
            owned.Dispose();
    }
}
