using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;

namespace Rabit.Hosting;

/// <summary>What surrounds an entry of the log: the reactor and its time in seconds. Immutable.</summary>
internal sealed class ReactorScope(string reactor, TimeSpan time) : IReadOnlyList<KeyValuePair<string, object?>>
{
    public int Count => 2;

    public KeyValuePair<string, object?> this[int index] => index switch
    {
        0 => new("Reactor", reactor),
        1 => new("ReactorSeconds", time.TotalSeconds),
        _ => throw new ArgumentOutOfRangeException(nameof(index)),
    };

    public IEnumerator<KeyValuePair<string, object?>> GetEnumerator()
    {
        for (int i = 0; i < Count; i++)
            yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    public override string ToString()
        => string.Format(CultureInfo.InvariantCulture, "{0} {1:0.000000} s", reactor, time.TotalSeconds);
}
