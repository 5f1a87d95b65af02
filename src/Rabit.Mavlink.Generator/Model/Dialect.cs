using System.Collections.Generic;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>What a root file defines together with everything it includes.</summary>
/// <param name="Name">File name of the root without folder and ending.</param>
/// <param name="Enums">Enums by name.</param>
/// <param name="Messages">Messages by id.</param>
public sealed record Dialect(
    string Name, IReadOnlyList<EnumDefinition> Enums, IReadOnlyList<MessageDefinition> Messages)
{
    /// <summary>Its files, included ones first, each with all that it includes.</summary>
    public IReadOnlyList<DialectPart> Parts { get; init; } = [];
}
