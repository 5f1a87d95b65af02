using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core;

/// <summary>
/// What managers declared does not fit together. Thrown before any thread starts; all faults are reported together.
/// </summary>
public sealed class RabitWiringException : Exception
{
    /// <summary>For programs that check several reactors, and report the faults of all.</summary>
    /// <param name="faults">Those of <see cref="RabitReactor.FindWiringFaults"/>.</param>
    public RabitWiringException(IReadOnlyList<string> faults)
        : base("The managers cannot be wired:" + string.Concat(faults.Select(f => "\n- " + f))) => Faults = faults;

    /// <summary>One line for each fault, with the names of the managers, messages and queues.</summary>
    public IReadOnlyList<string> Faults { get; }
}
