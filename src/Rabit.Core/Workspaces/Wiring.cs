using System;
using System.Collections.Generic;

namespace Rabit.Core.Workspaces;

/// <summary>All declarations of a workspace, grouped by what they name. In the order of declaration, so that two runs read alike.</summary>
internal sealed class Wiring
{
    private readonly SortedDictionary<string, IReadOnlyList<EndDeclaration>> _messages = new(StringComparer.Ordinal);
    private readonly SortedDictionary<string, IReadOnlyList<EndDeclaration>> _queues = new(StringComparer.Ordinal);

    public Wiring(IReadOnlyList<RabitManager> managers, IReadOnlyList<EndDeclaration> outside)
    {
        Managers = managers;
        foreach (RabitManager manager in managers)
            Add(manager.Declarations);
        Add(outside);
    }

    public IReadOnlyList<RabitManager> Managers { get; }

    public IReadOnlyDictionary<string, IReadOnlyList<EndDeclaration>> Messages => _messages;

    public IReadOnlyDictionary<string, IReadOnlyList<EndDeclaration>> Queues => _queues;

    private void Add(IEnumerable<EndDeclaration> declarations)
    {
        foreach (EndDeclaration declaration in declarations)
        {
            SortedDictionary<string, IReadOnlyList<EndDeclaration>> byName = declaration.IsMessage ? _messages : _queues;
            if (!byName.TryGetValue(declaration.Name, out IReadOnlyList<EndDeclaration>? ends))
                byName.Add(declaration.Name, ends = new List<EndDeclaration>());
            ((List<EndDeclaration>)ends).Add(declaration);
        }
    }
}
