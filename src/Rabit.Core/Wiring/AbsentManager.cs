using System;
using System.Collections.Generic;

namespace Rabit.Core;

/// <summary>
/// A manager that is meant to be absent from a reactor, and what it would have published, sent and received there.
/// Where the other managers need that and have it from nowhere else, the check of the wiring reports it as missing and
/// names this manager. See <see cref="RabitWorkspace.LeaveOut"/>.
/// </summary>
/// <remarks>Immutable; any thread.</remarks>
public sealed class AbsentManager
{
    /// <summary>Says which manager is absent.</summary>
    /// <param name="name">The name that it would have; its status message is missing with it.</param>
    /// <param name="reason">Why it is absent, for the text of a fault: "was left out (Options.Without)".</param>
    /// <exception cref="ArgumentException">The name or the reason is empty.</exception>
    public AbsentManager(string name, string reason)
    {
        Name = Require.Name(name, nameof(name), "An absent manager");
        Reason = Require.Name(reason, nameof(reason), "The reason of an absent manager");
    }

    /// <summary>The name that it would have.</summary>
    public string Name { get; }

    /// <summary>Why it is absent.</summary>
    public string Reason { get; }

    /// <summary>The messages that it would publish.</summary>
    public IReadOnlyCollection<string> Publishes { get; init; } = [];

    /// <summary>The queues that it would send to.</summary>
    public IReadOnlyCollection<string> Sends { get; init; } = [];

    /// <summary>The queues that it would receive.</summary>
    public IReadOnlyCollection<string> Receives { get; init; } = [];
}
