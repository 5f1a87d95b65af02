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

    /// <summary>
    /// What an entry without a value gets: one more than the largest so far, and 1 for the first, as mavgen counts.
    /// </summary>
    public decimal NextValue => Math.Max(0, _entries.Select(entry => entry.Value).DefaultIfEmpty().Max()) + 1;

    /// <summary>
    /// Adds an entry, or nothing where the same one is there already. Where one of its name has another value, or one
    /// of another name has its value, nothing is added and that one is returned; otherwise null.
    /// </summary>
    public EnumEntry? TryAdd(EnumEntry entry)
    {
        EnumEntry? sameName = _entries.FirstOrDefault(
            other => string.Equals(other.Name, entry.Name, StringComparison.Ordinal));
        if (sameName is not null)
            return sameName.Value == entry.Value ? null : sameName;
        EnumEntry? sameValue = _entries.FirstOrDefault(other => other.Value == entry.Value);
        if (sameValue is null)
            _entries.Add(entry);
        return sameValue;
    }

    public EnumDefinition ToDefinition() => new(name, _entries.OrderBy(entry => entry.Value).ToList())
    {
        IsBitmask = IsBitmask,
        Description = Description,
        Marks = Marks,
    };
}
