using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Hosting;

/// <summary>
/// The reactors of a host cannot be started: settings are wrong, or managers cannot be made. Thrown by the start of the
/// host before any manager runs; all faults are reported together.
/// </summary>
public sealed class RabitHostingException : Exception
{
    internal RabitHostingException(IReadOnlyList<string> faults, Exception? inner = null)
        : base("The host cannot start its reactors:" + string.Concat(faults.Select(f => "\n- " + f)), inner)
        => Faults = faults;

    /// <summary>One line for each fault.</summary>
    public IReadOnlyList<string> Faults { get; }
}
