using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// A mission file that cannot be read, or a mission that cannot be flown. The message names the mission and all faults.
/// </summary>
public sealed class MissionPlanException : Exception
{
    internal MissionPlanException(string name, IEnumerable<string> faults)
        : this(name, faults.ToArray())
    {
    }

    private MissionPlanException(string name, string[] faults)
        : base($"Mission '{name}': {string.Join("; ", faults)}.")
        => Faults = faults;

    /// <summary>The faults, each with the path of its value.</summary>
    public IReadOnlyList<string> Faults { get; }
}
