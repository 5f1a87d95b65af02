using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>An enum while files are still adding to it.</summary>
internal sealed class MergedEnum(string name)
{
    private readonly List<EnumEntry> _entries = [];

    public string Name => name;

    public bool IsBitmask { get; set; }

    public string? Description { get; set; }

    public DefinitionMarks Marks { get; set; }

    /// <summary>What an entry without a value gets: one more than the largest so far.</summary>
    public decimal NextValue => _entries.Count == 0 ? 0 : _entries.Max(entry => entry.Value) + 1;

    /// <summary>Adds an entry, or nothing where the same one is there already; false where it is there with another value.</summary>
    public bool TryAdd(EnumEntry entry, out decimal otherValue)
    {
        EnumEntry? known = _entries.FirstOrDefault(candidate => string.Equals(candidate.Name, entry.Name, StringComparison.Ordinal));
        otherValue = known?.Value ?? entry.Value;
        if (known is null)
            _entries.Add(entry);
        return otherValue == entry.Value;
    }

    public EnumDefinition ToDefinition() => new(name, _entries.OrderBy(entry => entry.Value).ToList())
    {
        IsBitmask = IsBitmask,
        Description = Description,
        Marks = Marks,
    };
}
