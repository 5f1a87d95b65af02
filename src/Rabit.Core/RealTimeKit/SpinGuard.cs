using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.RealTimeKit;

/// <summary>
/// Keeps one CPU free of threads with real-time priority that may never sleep. One of a run; the engine lets managers
/// start one after the other, so it needs no lock.
/// </summary>
/// <remarks>
/// A runtime that must stop all threads for a collection waits for one that cannot run because another spins above it:
/// for hours, in dotnet/runtime#121623, or until the kernel's throttling lets it.
/// </remarks>
internal sealed class SpinGuard
{
    private readonly List<IReadOnlyList<int>> _spinners = [];   // the CPUs of each that was admitted

    /// <summary>Admits one more, unless all together could then occupy every CPU.</summary>
    /// <param name="own">The CPUs that it may run on.</param>
    /// <param name="all">All that the process may use.</param>
    public bool TryAdmit(IReadOnlyList<int> own, IReadOnlyList<int> all)
    {
        _spinners.Add(own);
        var spinnerOn = new Dictionary<int, int>();
        int occupied = Enumerable.Range(0, _spinners.Count).Count(spinner => TryPlace(spinner, all, spinnerOn, []));
        if (occupied < all.Count)
            return true;
        _spinners.RemoveAt(_spinners.Count - 1);
        return false;
    }

    // The largest number of CPUs that can be occupied at once: a matching, grown by augmenting paths.
    private bool TryPlace(int spinner, IReadOnlyList<int> all, Dictionary<int, int> spinnerOn, HashSet<int> tried)
    {
        foreach (int cpu in _spinners[spinner])
        {
            if (!all.Contains(cpu) || !tried.Add(cpu))
                continue;
            if (!spinnerOn.TryGetValue(cpu, out int other) || TryPlace(other, all, spinnerOn, tried))
            {
                spinnerOn[cpu] = spinner;
                return true;
            }
        }

        return false;
    }
}
