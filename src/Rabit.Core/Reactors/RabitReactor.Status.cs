using System;
using System.Linq;
using Rabit.Core.Managers;
using Rabit.Core.Wiring;

namespace Rabit.Core;

/// <content>What the managers do and how long their steps take, for people.</content>
public sealed partial class RabitReactor
{
    /// <summary>What the outside knows the run by (<see cref="ReactorOptions.Name"/>). Any thread.</summary>
    public string Name => _options.Name;

    /// <summary>
    /// How long the steps of a manager took in real time. In virtual time, where the status holds virtual durations, it
    /// is measured beside them and is never posted or logged. Any thread.
    /// </summary>
    /// <param name="managerName">The manager.</param>
    /// <returns>No steps in real time, where <see cref="ManagerStatus.UnitOfWorkTime"/> has it.</returns>
    /// <exception cref="ArgumentException">
    /// There is no manager of that name, or the managers are not wired yet.
    /// </exception>
    public DurationStatistics RealStepTime(string managerName)
    {
        Require.NotNull(managerName, nameof(managerName));
        if (!IsWired)
            throw NameSuggestion.NotStarted(managerName, [], nameof(managerName));
        ManagerActivity activity = _activities.Find(a => string.Equals(a.Name, managerName, StringComparison.Ordinal))
            ?? throw NameSuggestion.NotStarted(
                managerName, _activities.Select(a => a.Name), nameof(managerName));
        return _engine.RealStepTime(activity);
    }

    /// <summary>
    /// What all managers do and their figures up to now, as a table of text, one line each. Any thread.
    /// </summary>
    /// <returns>Empty before the managers are wired.</returns>
    public string StatusTable() => IsWired ? Supervision.StatusTable() : string.Empty;
}
