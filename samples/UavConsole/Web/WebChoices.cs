using System.Collections.Generic;

namespace UavConsole;

/// <summary>What the command line asked for of the live page.</summary>
internal sealed class WebChoices
{
    /// <summary>ADDRESS:PORT as given; null for the default.</summary>
    public string? Address { get; init; }

    /// <summary>The file of the token; null where browsers only watch.</summary>
    public string? TokenFile { get; init; }

    /// <summary>A folder of map tiles; null for none.</summary>
    public string? TileFolder { get; init; }

    /// <summary>Names by which browsers may reach the page.</summary>
    public IReadOnlyList<string> HostNames { get; init; } = [];
}
