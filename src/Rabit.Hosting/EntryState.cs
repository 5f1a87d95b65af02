using System;
using System.Collections;
using System.Collections.Generic;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>An entry of a reactor's log, as structured logs want it. Immutable.</summary>
internal sealed class EntryState(RabitLogEntry entry) : IReadOnlyList<KeyValuePair<string, object?>>
{
    public int Count => 4;

    public KeyValuePair<string, object?> this[int index] => index switch
    {
        0 => new("Kind", entry.Kind.ToString()),
        1 => new("Source", entry.Source),
        2 => new("Text", entry.Text),
        3 => new("{OriginalFormat}", "{Text}"),
        _ => throw new ArgumentOutOfRangeException(nameof(index)),
    };

    public IEnumerator<KeyValuePair<string, object?>> GetEnumerator()
    {
        for (int i = 0; i < Count; i++)
            yield return this[i];
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    public override string ToString() => entry.Text;
}
