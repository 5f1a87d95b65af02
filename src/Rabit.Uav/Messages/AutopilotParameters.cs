using System;
using System.Collections.Immutable;

namespace Rabit.Uav.Messages;

/// <summary>
/// The parameters of the autopilot that decide what it does by itself: failsafes, return, fence. Posted by Autopilot
/// Interface when one changes. Immutable.
/// </summary>
public sealed class AutopilotParameters
{
    /// <summary>None is read.</summary>
    public static AutopilotParameters None { get; } = new();

    /// <summary>Whether each has been asked for: those that have no value then were not answered.</summary>
    public bool IsComplete { get; init; }

    /// <summary>
    /// The parameters that were asked for, by all their names; of names that replace each other (<c>RTL_ALT</c>,
    /// <c>RTL_ALT_M</c>) an autopilot knows one.
    /// </summary>
    public ImmutableArray<AutopilotParameter> All { get; init; } = [];

    /// <summary>Whether failsafes and fence were written.</summary>
    public AutopilotSetupState Setup { get; init; }

    /// <summary>What was written, or why not, as text; null where there is nothing to report.</summary>
    public string? SetupText { get; init; }

    /// <summary>Looks a parameter up by its name.</summary>
    /// <param name="name">The autopilot's own name.</param>
    /// <param name="parameter">The parameter.</param>
    /// <returns>Whether its value is known.</returns>
    public bool TryGet(string name, out AutopilotParameter parameter)
    {
        foreach (AutopilotParameter candidate in All)
        {
            if (!string.Equals(candidate.Name, name, StringComparison.Ordinal))
                continue;
            parameter = candidate;
            return candidate.IsKnown;
        }

        parameter = default;
        return false;
    }
}
