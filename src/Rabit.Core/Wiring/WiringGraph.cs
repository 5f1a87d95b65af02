using System;
using System.Collections.Generic;

namespace Rabit.Core.Wiring;

/// <summary>
/// All declarations of a workspace, grouped by what they name. In the order of declaration, so that two runs read
/// alike.
/// </summary>
internal sealed class WiringGraph
{
    private readonly SortedDictionary<string, IReadOnlyList<EndpointDeclaration>> _messages = new(
        StringComparer.Ordinal);
    private readonly SortedDictionary<string, IReadOnlyList<EndpointDeclaration>> _queues = new(StringComparer.Ordinal);

    public WiringGraph(IReadOnlyList<RabitManager> managers, IReadOnlyList<EndpointDeclaration> outside)
    {
        Managers = managers;
        foreach (RabitManager manager in managers)
            Add(manager.Declarations);
        Add(outside);
    }

    public IReadOnlyList<RabitManager> Managers { get; }

    public IReadOnlyDictionary<string, IReadOnlyList<EndpointDeclaration>> Messages => _messages;

    public IReadOnlyDictionary<string, IReadOnlyList<EndpointDeclaration>> Queues => _queues;

    /// <summary>What the check found odd, beside what <see cref="WiringText.Notes"/> finds by itself.</summary>
    public List<string> Notes { get; } = [];

    private void Add(IEnumerable<EndpointDeclaration> declarations)
    {
        foreach (EndpointDeclaration declaration in declarations)
        {
            SortedDictionary<string, IReadOnlyList<EndpointDeclaration>> byName = declaration.IsMessage
                ? _messages
                : _queues;
            if (!byName.TryGetValue(declaration.Name, out IReadOnlyList<EndpointDeclaration>? endpoints))
                byName.Add(declaration.Name, endpoints = new List<EndpointDeclaration>());
            ((List<EndpointDeclaration>)endpoints).Add(declaration);
        }
    }
}
