using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Mavlink.Definitions;

namespace Rabit.Mavlink;

/// <summary>
/// An enum as its definition has it, for tools that learn of it at run time. Immutable, safe from any thread.
/// </summary>
public sealed class MavlinkEnumDefinition
{
    private readonly MavlinkEnumEntry[] _entries;

    internal MavlinkEnumDefinition(string name, bool isBitmask, IEnumerable<MavlinkEnumEntry> entries)
    {
        Name = name;
        IsBitmask = isBitmask;
        // stable: of two names for one value the first given stays first
        _entries = entries.OrderBy(entry => entry.Value).ToArray();
    }

    /// <summary>Name as the definition writes it, for example <c>MAV_TYPE</c>.</summary>
    public string Name { get; }

    /// <summary>Whether its values are combined bit by bit.</summary>
    public bool IsBitmask { get; }

    /// <summary>Its entries by value, with those that another file of the dialect adds.</summary>
    public IReadOnlyList<MavlinkEnumEntry> Entries => _entries;

    /// <summary>Looks a value up.</summary>
    /// <param name="value">The number, as <see cref="MavlinkFieldValue.ToInt64"/> gives it.</param>
    /// <returns>The name of exactly this value; null where it has none.</returns>
    public string? NameOf(long value)
    {
        int low = 0;
        int high = _entries.Length;
        while (low < high)
        {
            int middle = (low + high) / 2;
            if (_entries[middle].Value < value)
                low = middle + 1;
            else
                high = middle;
        }

        return low < _entries.Length && _entries[low].Value == value ? _entries[low].Name : null;
    }

    /// <summary>
    /// Writes a value as a person reads it: its name, the names of its bits joined by <c>|</c>, or the number where it
    /// has no name.
    /// </summary>
    /// <param name="text">Where to write.</param>
    /// <param name="value">The number.</param>
    public void AppendTo(StringBuilder text, long value)
    {
        if (text is null)
            throw new ArgumentNullException(nameof(text));
        if (NameOf(value) is { } name)
            text.Append(name);
        else if (IsBitmask && value != 0)
            AppendBits(text, value);
        else
            NumberFormat.Append(text, value);
    }

    // Entries of several bits are not tried: their bits have names of their own, or are written as a number.
    private void AppendBits(StringBuilder text, long value)
    {
        long rest = value;
        int start = text.Length;
        foreach (MavlinkEnumEntry entry in _entries)
        {
            bool isOneBit = entry.Value != 0 && (entry.Value & (entry.Value - 1)) == 0;
            if (!isOneBit || (rest & entry.Value) == 0)
                continue;
            text.Append(text.Length == start ? "" : "|").Append(entry.Name);
            rest &= ~entry.Value;
        }

        if (rest != 0)
            text.Append(text.Length == start ? "0x" : "|0x").Append(rest.ToString("X", CultureInfo.InvariantCulture));
    }
}
