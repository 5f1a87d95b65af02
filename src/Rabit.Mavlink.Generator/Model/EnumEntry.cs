using System.Collections.Generic;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>One named value of an enum.</summary>
/// <param name="Name">Name in the definition.</param>
/// <param name="Value">The number; a decimal holds every 64-bit one, signed or not.</param>
public sealed record EnumEntry(string Name, decimal Value)
{
    /// <summary>The definition's own words.</summary>
    public string? Description { get; init; }

    /// <summary>Where it is defined; null where it was not read from a file.</summary>
    public DefinitionPlace? Place { get; init; }

    /// <summary>Its age.</summary>
    public DefinitionMarks Marks { get; init; }

    /// <summary>
    /// What to use instead of a deprecated or superseded one; null where the definition names nothing.
    /// </summary>
    public string? ReplacedBy { get; init; }

    /// <summary>Meaning of the parameters where the entry is a command.</summary>
    public IReadOnlyList<CommandParameter> Parameters { get; init; } = [];
}
