using System.Collections.Generic;

namespace Rabit.Documentation.Tests;

/// <summary>A message or a queue of a wiring: its name, and the managers and devices at its ends.</summary>
internal sealed class WiringChannel(string name, bool isMessage)
{
    public string Name { get; } = name;

    public bool IsMessage { get; } = isMessage;

    /// <summary>Who posts or pushes.</summary>
    public List<string> From { get; } = [];

    /// <summary>Who fetches or pops, and whether a post or push wakes it.</summary>
    public List<(string Owner, bool Wakes)> To { get; } = [];
}
