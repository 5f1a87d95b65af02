using System;
using System.Collections.Generic;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// Down-level there is no meter without a package of its own, and Mono has no tool that reads one: the figures are in
/// the status, in <see cref="ReactorResult.ToTable"/> and in the events.
/// </summary>
internal sealed class ManagerMeter : IDisposable
{
    public ManagerMeter(string run, IReadOnlyList<string> managers, Func<ManagerStatus[]> read)
    {
        _ = run;
        _ = managers;
        _ = read;
    }

    public void Dispose()
    {
    }
}
