using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Rabit.Core.Wiring;

/// <summary>
/// Draws a wiring: managers and devices as boxes, messages rounded, queues slanted. Arrows go the way of the data;
/// thick ones wake whom they point at, and a sender that pops wake is marked on its arrow.
/// </summary>
internal static class WiringDrawing
{
    private const string WokenByPop = "woken by pops";

    public static string Mermaid(WiringGraph wiring)
    {
        var text = new StringBuilder("flowchart LR\n");
        Dictionary<string, string> owners = Owners(wiring);
        foreach (KeyValuePair<string, string> owner in owners)
            Line(text, $"  {owner.Value}[\"{Escaped(owner.Key, "#quot;")}\"]");
        foreach ((string id, IReadOnlyList<EndpointDeclaration> endpoints) in Connectors(wiring))
        {
            string label = $"\"{Escaped(endpoints[0].Name, "#quot;")}\"";
            Line(text, "  " + id + (endpoints[0].IsMessage ? $"([{label}])" : $"[/{label}/]"));
            foreach (EndpointDeclaration endpoint in endpoints)
                Line(text, "  " + MermaidArrow(endpoint, owners[endpoint.Owner.Name], id));
        }

        return text.ToString();
    }

    public static string Dot(WiringGraph wiring)
    {
        var text = new StringBuilder("digraph wiring {\n  rankdir=LR;\n");
        Dictionary<string, string> owners = Owners(wiring);
        foreach (KeyValuePair<string, string> owner in owners)
            Line(text, $"  {owner.Value} [shape=box, label=\"{Escaped(owner.Key, "\\\"")}\"];");
        foreach ((string id, IReadOnlyList<EndpointDeclaration> endpoints) in Connectors(wiring))
        {
            Line(text, $"  {id} [shape={(endpoints[0].IsMessage ? "ellipse" : "parallelogram")}, "
                + $"label=\"{Escaped(endpoints[0].Name, "\\\"")}\"];");
            foreach (EndpointDeclaration endpoint in endpoints)
                Line(text, "  " + DotArrow(endpoint, owners[endpoint.Owner.Name], id));
        }

        return text.Append("}\n").ToString();
    }

    // In the order of their start; then devices and code outside, in the order in which they are met.
    private static Dictionary<string, string> Owners(WiringGraph wiring)
    {
        IEnumerable<string> names = wiring.Managers.Select(m => m.Name)
            .Concat(Connectors(wiring).SelectMany(h => h.Endpoints).Select(e => e.Owner.Name))
            .Distinct(StringComparer.Ordinal);
        return names.Select((name, index) => (name, id: Id("m", index)))
            .ToDictionary(o => o.name, o => o.id, StringComparer.Ordinal);
    }

    // Statuses without a subscriber would be half of the picture.
    private static IEnumerable<(string Id, IReadOnlyList<EndpointDeclaration> Endpoints)> Connectors(WiringGraph wiring)
        => wiring.Messages.Values.Where(endpoints => !endpoints.All(e => e.IsBuiltIn)).Concat(wiring.Queues.Values)
            .Select((endpoints, index) => (Id("c", index), endpoints));

    private static bool IsInto(EndpointDeclaration endpoint)
        => endpoint.Role is EndpointRole.Publish or EndpointRole.Send;

    private static string MermaidArrow(EndpointDeclaration endpoint, string owner, string connector)
    {
        if (IsInto(endpoint))
            return endpoint.Wakes ? $"{owner} -- {WokenByPop} --> {connector}" : $"{owner} --> {connector}";
        return $"{connector} {(endpoint.Wakes ? "==>" : "-->")} {owner}";
    }

    private static string DotArrow(EndpointDeclaration endpoint, string owner, string connector)
    {
        if (IsInto(endpoint))
            return $"{owner} -> {connector}{(endpoint.Wakes ? $" [label=\"{WokenByPop}\"]" : string.Empty)};";
        return $"{connector} -> {owner}{(endpoint.Wakes ? " [penwidth=2]" : string.Empty)};";
    }

    private static string Id(string kind, int index) => kind + index.ToString(CultureInfo.InvariantCulture);

    // Names are the user's own: nothing in them may end the label.
    private static string Escaped(string name, string quote)
        => name.Replace("\\", "/").Replace("\"", quote).Replace("\r", " ").Replace("\n", " ");

    private static void Line(StringBuilder text, string words) => text.Append(words).Append('\n');
}
