using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Rabit.Core;
using Rabit.Uav.HealthMonitoring;

namespace Rabit.Documentation.Tests;

/// <summary>
/// The drawing and the table of docs/architecture.md, made from the wiring. All edges of one direction between two
/// managers are one arrow. What Health Monitoring fetches is only in the table: it fetches something of every manager,
/// which would hide the rest.
/// </summary>
internal static class ArchitectureDrawing
{
    private const string StatusSuffix = "/status";

    public static string Render()
    {
        var graph = new WiringGraph(ComposedSystem.DescribeWiring(WiringFormat.Mermaid));
        Dictionary<string, string> types = TypesOf(ComposedSystem.DescribeWiring(WiringFormat.Text));
        return "```mermaid\n" + Flowchart(graph) + "```\n\n" + Table(graph, types);
    }

    private static string Flowchart(WiringGraph graph)
    {
        var text = new StringBuilder("flowchart LR\n");
        List<Edge> edges = graph.Channels.SelectMany(EdgesOf).ToList();
        List<string> devices = edges.SelectMany(e => new[] { e.From, e.To })
            .Where(WiringGraph.IsDevice).Distinct(StringComparer.Ordinal).ToList();
        foreach (string manager in graph.Managers)
            text.Append($"  {IdOf(manager)}[\"{manager}\"]\n");
        foreach (string device in devices)
            text.Append($"  {IdOf(device)}([\"{device.AsSpan(device.IndexOf('/') + 1)}\"])\n");
        foreach (IGrouping<(string, string, bool), Edge> arrow in edges.GroupBy(e => (e.From, e.To, e.IsMessage)))
        {
            string label = string.Join("<br/>", arrow.Select(e => e.Label).Where(l => l.Length > 0));
            string line = (arrow.Key.Item3 ? "-.->" : "-->") + (label.Length > 0 ? $"|\"{label}\"|" : string.Empty);
            text.Append($"  {IdOf(arrow.Key.Item1)} {line} {IdOf(arrow.Key.Item2)}\n");
        }

        return text.ToString();
    }

    private static IEnumerable<Edge> EdgesOf(WiringChannel channel)
        => from source in channel.From
           from target in channel.To
           where !string.Equals(target.Owner, HealthManager.ManagerName, StringComparison.Ordinal)
           let label = WiringGraph.IsDevice(source) || WiringGraph.IsDevice(target.Owner) ? string.Empty : channel.Name
           select new Edge(source, target.Owner, channel.IsMessage, label);

    private static string Table(WiringGraph graph, Dictionary<string, string> types)
    {
        var text = new StringBuilder("| name | kind | type | from | to (**woken by it**) |\n|---|---|---|---|---|\n");
        foreach (WiringChannel channel
            in graph.Channels.Where(h => !h.Name.EndsWith(StatusSuffix, StringComparison.Ordinal)))
        {
            string readers = string.Join(", ", channel.To.Select(t => t.Wakes ? $"**{t.Owner}**" : t.Owner));
            string kind = channel.IsMessage ? "message" : "queue";
            string to = readers.Length > 0 ? readers : "code outside managers";
            text.Append(
                $"| {channel.Name} | {kind} | `{types[channel.Name]}` | {string.Join(", ", channel.From)} | {to} |\n");
        }

        const string Status = $"| MANAGER{StatusSuffix} | message | `{nameof(ManagerStatus)}` | every manager |";
        return text.Append($"{Status} {HealthManager.ManagerName} |\n").ToString();
    }

    // "queue poses : PoseSample, 1000 at most, when full DropOldest"
    private static Dictionary<string, string> TypesOf(string wiring)
        => Regex.Matches(wiring, "^(?:message|queue) (.+?) : ([^,\n]+)", RegexOptions.Multiline).Cast<Match>()
            .ToDictionary(m => m.Groups[1].Value, m => m.Groups[2].Value, StringComparer.Ordinal);

    private static string IdOf(string owner) => Regex.Replace(owner, "[^a-z0-9]", "_");

    private sealed class Edge(string from, string to, bool isMessage, string label)
    {
        public string From { get; } = from;

        public string To { get; } = to;

        public bool IsMessage { get; } = isMessage;

        public string Label { get; } = label;
    }
}
