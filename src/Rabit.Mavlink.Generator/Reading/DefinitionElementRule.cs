using System.Collections.Generic;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>What one element of a definition may have.</summary>
/// <param name="Name">Name of the element.</param>
/// <param name="Attributes">Names of its attributes.</param>
/// <param name="Children">Names of the elements in it.</param>
internal sealed record DefinitionElementRule(
    string Name, IReadOnlyList<string> Attributes, IReadOnlyList<string> Children);
