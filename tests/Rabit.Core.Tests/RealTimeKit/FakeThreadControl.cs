using System.Collections.Generic;
using System.Linq;
using Rabit.Core.RealTimeKit;

namespace Rabit.Core.Tests.RealTimeKit;

/// <summary>An operating system that grants or refuses what the test says, and writes down what it was asked.</summary>
internal sealed class FakeThreadControl : IThreadControl
{
    private IReadOnlyList<int> _cpus;

    public FakeThreadControl(params int[] cpus) => _cpus = AllCpus = cpus;

    public IReadOnlyList<int> AllCpus { get; }

    public List<string> Asked { get; } = [];

    /// <summary>What every call but that of the CPUs answers.</summary>
    public int Error { get; set; }

    public bool ThrottlesRealTime { get; set; } = true;

    public IReadOnlyList<int> Cpus => _cpus;

    /// <summary>Another thread begins, which may run anywhere.</summary>
    public void NextThread() => _cpus = AllCpus;

    public int SetPriority(RealTimePolicy policy, int priority) => Answer($"{policy} {priority}");

    public int SetCpus(IReadOnlyList<int> cpus)
    {
        Asked.Add("CPUs " + string.Join(",", cpus));
        int[] allowed = [.. cpus.Intersect(AllCpus)];
        if (allowed.Length == 0)
            return SystemErrors.Invalid;
        _cpus = allowed;
        return 0;
    }

    public int SetTimerSlack(long nanoseconds) => Answer($"slack {nanoseconds}");

    public int LockMemory() => Answer("lock");

    private int Answer(string asked)
    {
        Asked.Add(asked);
        return Error;
    }
}
