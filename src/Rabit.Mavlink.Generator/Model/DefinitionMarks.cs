using System;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>
/// What a definition says of its own age: <c>wip</c>, <c>deprecated</c> and <c>superseded</c> elements.
/// </summary>
[Flags]
public enum DefinitionMarks
{
    /// <summary>In force.</summary>
    None = 0,

    /// <summary>May still change without notice.</summary>
    WorkInProgress = 1,

    /// <summary>Should no longer be sent.</summary>
    Deprecated = 2,

    /// <summary>Something newer does the same; this one stays valid.</summary>
    Superseded = 4,
}
