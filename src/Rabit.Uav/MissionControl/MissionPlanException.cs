using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>A mission file that is none, or that cannot be flown. The message names the mission and all that is wrong.</summary>
public sealed class MissionPlanException : Exception
{
    internal MissionPlanException(string name, IEnumerable<string> faults)
        : this(name, faults.ToArray())
    {
    }

    private MissionPlanException(string name, string[] faults)
        : base($"Mission '{name}': {string.Join("; ", faults)}.")
        => Faults = faults;

    /// <summary>What is wrong, each with the path of the value.</summary>
    public IReadOnlyList<string> Faults { get; }
}
