using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Links;

namespace UavConsole;

/// <summary>
/// What the command line asks for, and where it says nothing the configuration file. Immutable.
/// </summary>
internal sealed class Given
{
    /// <summary>Null where there is none.</summary>
    public ConfigFile? Config { get; init; }

    /// <summary>In their order; none for the simulation.</summary>
    public IReadOnlyList<LinkUrl> Links { get; init; } = [];

    public bool IsSimulated => Links.Count == 0;

    public bool IsReplay => Links.Count > 0 && Links.All(l => l.Kind == LinkKind.RecordedFile);

    /// <summary>Whether a real vehicle may be commanded.</summary>
    public Setting<bool> Flies { get; init; }

    public Setting<string?> Mission { get; init; }

    public Setting<string?> Camera { get; init; }

    public Setting<string?> Terrain { get; init; }

    public Setting<string?> SignKey { get; init; }

    public IReadOnlyList<int> TrustedLinks { get; init; } = [];

    /// <summary>Whether the mission is flown without a camera.</summary>
    public bool IsWithoutDetection { get; init; }

    /// <summary>A text of the command line, or else of the file.</summary>
    public static Setting<string?> TextOf(string? given, string option, ConfigFile? config, string key)
        => given is null && config?.TextOf(key) is { } text
            ? new Setting<string?>(text, config.NameOf(key))
            : new Setting<string?>(given, option);

    /// <summary>Numbers of links that are not signed, of the file, which has checked them.</summary>
    public static IReadOnlyList<int> TrustedLinksOf(ConfigFile? config)
    {
        var links = new List<int>();
        while (config?.TextOf($"Signing:TrustedLinks:{links.Count}") is { } text)
            links.Add(int.Parse(text, CultureInfo.InvariantCulture));
        return links;
    }
}
