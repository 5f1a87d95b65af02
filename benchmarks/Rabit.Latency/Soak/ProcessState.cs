using System;
using System.IO;
using System.Linq;
using System.Threading;

namespace Rabit.Latency.Soak;

/// <summary>What a process holds at one instant, between two workspaces.</summary>
internal readonly struct ProcessState(int threads, int handles, long heapBytes, long residentBytes)
{
    private const string Status = "/proc/self/status";
    private const int LooksUnchanged = 10;

    private static readonly TimeSpan BetweenLooks = TimeSpan.FromMilliseconds(2);

    /// <summary>Of the operating system, the runtime's own included.</summary>
    public int Threads => threads;

    /// <summary>Open file descriptors.</summary>
    public int Handles => handles;

    /// <summary>What the collector still reaches after a full collection.</summary>
    public long HeapBytes => heapBytes;

    /// <summary>Memory that the process really has.</summary>
    public long ResidentBytes => residentBytes;

    /// <summary>
    /// Waits, for a moment, until threads of a run that has ended have exited: on a busy machine they take longer
    /// (decision 0066).
    /// </summary>
    public static ProcessState WhenSettled()
    {
        ProcessState state = Now();
        for (int unchanged = 0; unchanged < LooksUnchanged; unchanged++)
        {
            Thread.Sleep(BetweenLooks);
            int threads = (int)Number(File.ReadAllLines(Status), "Threads:");
            if (threads >= state.Threads)
                continue;
            state = new ProcessState(threads, state.Handles, state.HeapBytes, state.ResidentBytes);
            unchanged = -1;
        }

        return state;
    }

    public static ProcessState Now()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        long heap = GC.GetTotalMemory(forceFullCollection: true);
        string[] status = File.ReadAllLines(Status);
        return new ProcessState(
            (int)Number(status, "Threads:"),
            Directory.GetFileSystemEntries("/proc/self/fd").Length,
            heap,
            Number(status, "VmRSS:") * 1024);
    }

    private static long Number(string[] status, string label)
    {
        string line = status.First(l => l.StartsWith(label, StringComparison.Ordinal));
        return long.Parse(new string([.. line.Where(char.IsDigit)]), System.Globalization.CultureInfo.InvariantCulture);
    }
}
