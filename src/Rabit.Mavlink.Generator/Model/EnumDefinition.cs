using System.Collections.Generic;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>One enum, with the entries of every file that adds to it.</summary>
/// <param name="Name">Name in the definition.</param>
/// <param name="Entries">Entries by value; those of one value in the order of the files.</param>
public sealed record EnumDefinition(string Name, IReadOnlyList<EnumEntry> Entries)
{
    /// <summary>Whether its values are combined bit by bit.</summary>
    public bool IsBitmask { get; init; }

    /// <summary>The definition's own words.</summary>
    public string? Description { get; init; }

    /// <summary>Its age.</summary>
    public DefinitionMarks Marks { get; init; }
}
