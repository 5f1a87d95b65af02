using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Rabit.Documentation.Tests;

/// <summary>A wiring, read from its Mermaid flowchart.</summary>
internal sealed class WiringGraph
{
    private static readonly Regex Box = new("^  (m\\d+)\\[\"(.+)\"\\]$", RegexOptions.Compiled);
    private static readonly Regex Channel = new("^  (c\\d+)(\\(\\[|\\[/)\"(.+)\"", RegexOptions.Compiled);
    private static readonly Regex Arrow = new("^  ([mc]\\d+) (-->|==>|-- .+ -->) ([mc]\\d+)$", RegexOptions.Compiled);

    public WiringGraph(string mermaid)
    {
        var owners = new Dictionary<string, string>(StringComparer.Ordinal);
        var channels = new Dictionary<string, WiringChannel>(StringComparer.Ordinal);
        foreach (string line in mermaid.Split(['\n'], StringSplitOptions.RemoveEmptyEntries).Skip(1))
        {
            if (Box.Match(line) is { Success: true } box)
                owners.Add(box.Groups[1].Value, box.Groups[2].Value);
            else if (Channel.Match(line) is { Success: true } channel)
                channels.Add(
                    channel.Groups[1].Value,
                    new WiringChannel(channel.Groups[3].Value, channel.Groups[2].Value == "(["));
            else if (Arrow.Match(line) is { Success: true } arrow)
                AddArrow(
                    owners, channels, arrow.Groups[1].Value, arrow.Groups[3].Value, arrow.Groups[2].Value == "==>");
            else
                throw new FormatException($"'{line}' is not a line of a wiring.");
        }

        Managers = owners.Values.Where(o => !IsDevice(o)).ToList();
        Channels = channels.Values.ToList();
    }

    /// <summary>In the order of their start.</summary>
    public IReadOnlyList<string> Managers { get; }

    /// <summary>Messages, then queues, by name.</summary>
    public IReadOnlyList<WiringChannel> Channels { get; }

    /// <summary>A reader or writer is named after its manager: "communications/link 0 in".</summary>
    public static bool IsDevice(string owner) => owner.Contains('/', StringComparison.Ordinal);

    private static void AddArrow(
        Dictionary<string, string> owners, Dictionary<string, WiringChannel> channels, string from, string to,
        bool wakes)
    {
        if (channels.TryGetValue(to, out WiringChannel? into))
            into.From.Add(owners[from]);
        else
            channels[from].To.Add((owners[to], wakes));
    }
}
