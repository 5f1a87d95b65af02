using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Rabit.Core.Workspaces;

/// <summary>
/// Draws a wiring: managers and devices as boxes, messages rounded, queues slanted. Arrows go the way of the data; thick ones wake whom they
/// point at, and a sender that pops wake is marked on its arrow.
/// </summary>
internal static class WiringDrawing
{
    private const string WokenByPop = "woken by pops";

    public static string Mermaid(Wiring wiring)
    {
        var text = new StringBuilder("flowchart LR\n");
        Dictionary<string, string> owners = Owners(wiring);
        foreach (KeyValuePair<string, string> owner in owners)
            Line(text, $"  {owner.Value}[\"{Escaped(owner.Key, "#quot;")}\"]");
        foreach ((string id, IReadOnlyList<EndDeclaration> ends) in Hubs(wiring))
        {
            string label = $"\"{Escaped(ends[0].Name, "#quot;")}\"";
            Line(text, "  " + id + (ends[0].IsMessage ? $"([{label}])" : $"[/{label}/]"));
            foreach (EndDeclaration end in ends)
                Line(text, "  " + MermaidArrow(end, owners[end.Owner.Name], id));
        }

        return text.ToString();
    }

    public static string Dot(Wiring wiring)
    {
        var text = new StringBuilder("digraph wiring {\n  rankdir=LR;\n");
        Dictionary<string, string> owners = Owners(wiring);
        foreach (KeyValuePair<string, string> owner in owners)
            Line(text, $"  {owner.Value} [shape=box, label=\"{Escaped(owner.Key, "\\\"")}\"];");
        foreach ((string id, IReadOnlyList<EndDeclaration> ends) in Hubs(wiring))
        {
            Line(text, $"  {id} [shape={(ends[0].IsMessage ? "ellipse" : "parallelogram")}, label=\"{Escaped(ends[0].Name, "\\\"")}\"];");
            foreach (EndDeclaration end in ends)
                Line(text, "  " + DotArrow(end, owners[end.Owner.Name], id));
        }

        return text.Append("}\n").ToString();
    }

    // In the order of their start; then devices and code outside, in the order in which they are met.
    private static Dictionary<string, string> Owners(Wiring wiring)
    {
        IEnumerable<string> names = wiring.Managers.Select(m => m.Name)
            .Concat(Hubs(wiring).SelectMany(h => h.Ends).Select(e => e.Owner.Name))
            .Distinct(StringComparer.Ordinal);
        return names.Select((name, index) => (name, id: Id("m", index))).ToDictionary(o => o.name, o => o.id, StringComparer.Ordinal);
    }

    // The statuses that nobody fetches would be half of the picture.
    private static IEnumerable<(string Id, IReadOnlyList<EndDeclaration> Ends)> Hubs(Wiring wiring)
        => wiring.Messages.Values.Where(ends => !ends.All(e => e.IsBuiltIn)).Concat(wiring.Queues.Values).Select((ends, index) => (Id("h", index), ends));

    private static bool IsInto(EndDeclaration end) => end.Role is EndRole.Publish or EndRole.Send;

    private static string MermaidArrow(EndDeclaration end, string owner, string hub)
    {
        if (IsInto(end))
            return end.Wakes ? $"{owner} -- {WokenByPop} --> {hub}" : $"{owner} --> {hub}";
        return $"{hub} {(end.Wakes ? "==>" : "-->")} {owner}";
    }

    private static string DotArrow(EndDeclaration end, string owner, string hub)
    {
        if (IsInto(end))
            return $"{owner} -> {hub}{(end.Wakes ? $" [label=\"{WokenByPop}\"]" : string.Empty)};";
        return $"{hub} -> {owner}{(end.Wakes ? " [penwidth=2]" : string.Empty)};";
    }

    private static string Id(string kind, int index) => kind + index.ToString(CultureInfo.InvariantCulture);

    // Names are the user's own: nothing in them may end the label.
    private static string Escaped(string name, string quote)
        => name.Replace("\\", "/").Replace("\"", quote).Replace("\r", " ").Replace("\n", " ");

    private static void Line(StringBuilder text, string words) => text.Append(words).Append('\n');
}
