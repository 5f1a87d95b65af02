using System;
using System.Collections.Generic;

namespace Rabit.Core.Wiring;

/// <summary>
/// All declarations of a workspace, grouped by what they name, sorted by that name, so that two runs read alike.
/// </summary>
internal sealed class WiringGraph
{
    public WiringGraph(IReadOnlyList<RabitManager> managers, IReadOnlyList<EndpointDeclaration> outside)
    {
        Managers = managers;
        var messages = new Dictionary<string, IReadOnlyList<EndpointDeclaration>>(StringComparer.Ordinal);
        var queues = new Dictionary<string, IReadOnlyList<EndpointDeclaration>>(StringComparer.Ordinal);
        foreach (RabitManager manager in managers)
            Add(manager.Declarations, messages, queues);
        Add(outside, messages, queues);
        Messages = new SortedList<string, IReadOnlyList<EndpointDeclaration>>(messages, StringComparer.Ordinal);
        Queues = new SortedList<string, IReadOnlyList<EndpointDeclaration>>(queues, StringComparer.Ordinal);
    }

    public IReadOnlyList<RabitManager> Managers { get; }

    public IReadOnlyDictionary<string, IReadOnlyList<EndpointDeclaration>> Messages { get; }

    public IReadOnlyDictionary<string, IReadOnlyList<EndpointDeclaration>> Queues { get; }

    /// <summary>What the check found odd, beside what <see cref="WiringText.Notes"/> finds by itself.</summary>
    public List<string> Notes { get; } = [];

    private static void Add(
        IEnumerable<EndpointDeclaration> declarations,
        Dictionary<string, IReadOnlyList<EndpointDeclaration>> messages,
        Dictionary<string, IReadOnlyList<EndpointDeclaration>> queues)
    {
        foreach (EndpointDeclaration declaration in declarations)
        {
            Dictionary<string, IReadOnlyList<EndpointDeclaration>> byName = declaration.IsMessage ? messages : queues;
            if (!byName.TryGetValue(declaration.Name, out IReadOnlyList<EndpointDeclaration>? endpoints))
                byName.Add(declaration.Name, endpoints = new List<EndpointDeclaration>());
            ((List<EndpointDeclaration>)endpoints).Add(declaration);
        }
    }
}
