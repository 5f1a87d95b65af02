using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Rabit.Documentation.Tests;

/// <summary>A wiring, read from its Mermaid flowchart.</summary>
internal sealed class WiringGraph
{
    private static readonly Regex Box = new("^  (m\\d+)\\[\"(.+)\"\\]$", RegexOptions.Compiled);
    private static readonly Regex Hub = new("^  (h\\d+)(\\(\\[|\\[/)\"(.+)\"", RegexOptions.Compiled);
    private static readonly Regex Arrow = new("^  ([mh]\\d+) (-->|==>|-- .+ -->) ([mh]\\d+)$", RegexOptions.Compiled);

    public WiringGraph(string mermaid)
    {
        var owners = new Dictionary<string, string>(StringComparer.Ordinal);
        var hubs = new Dictionary<string, WiringHub>(StringComparer.Ordinal);
        foreach (string line in mermaid.Split(['\n'], StringSplitOptions.RemoveEmptyEntries).Skip(1))
        {
            if (Box.Match(line) is { Success: true } box)
                owners.Add(box.Groups[1].Value, box.Groups[2].Value);
            else if (Hub.Match(line) is { Success: true } hub)
                hubs.Add(hub.Groups[1].Value, new WiringHub(hub.Groups[3].Value, hub.Groups[2].Value == "(["));
            else if (Arrow.Match(line) is { Success: true } arrow)
                AddArrow(owners, hubs, arrow.Groups[1].Value, arrow.Groups[3].Value, arrow.Groups[2].Value == "==>");
            else
                throw new FormatException($"'{line}' is not a line of a wiring.");
        }

        Managers = owners.Values.Where(o => !IsDevice(o)).ToList();
        Hubs = hubs.Values.ToList();
    }

    /// <summary>In the order of their start.</summary>
    public IReadOnlyList<string> Managers { get; }

    /// <summary>Messages, then queues, by name.</summary>
    public IReadOnlyList<WiringHub> Hubs { get; }

    /// <summary>A reader or writer is named after its manager: "communications/link 0 in".</summary>
    public static bool IsDevice(string owner) => owner.Contains('/', StringComparison.Ordinal);

    private static void AddArrow(
        Dictionary<string, string> owners, Dictionary<string, WiringHub> hubs, string from, string to, bool wakes)
    {
        if (hubs.TryGetValue(to, out WiringHub? into))
            into.From.Add(owners[from]);
        else
            hubs[from].To.Add((owners[to], wakes));
    }
}
