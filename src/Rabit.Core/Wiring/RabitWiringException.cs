using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core;

/// <summary>
/// What managers declared does not fit together. Thrown before any thread starts; all faults are reported together.
/// </summary>
public sealed class RabitWiringException : Exception
{
    internal RabitWiringException(IReadOnlyList<string> faults)
        : base("The managers cannot be wired:" + string.Concat(faults.Select(f => "\n- " + f))) => Faults = faults;

    /// <summary>One line for each fault, with the names of the managers, messages and queues.</summary>
    public IReadOnlyList<string> Faults { get; }
}
