using System;
using System.IO;
using System.Linq;

namespace Rabit.Latency.Soak;

/// <summary>What a process holds at one instant, between two workspaces.</summary>
internal readonly struct ProcessState(int threads, int handles, long heapBytes, long residentBytes)
{
    /// <summary>Of the operating system, the runtime's own included.</summary>
    public int Threads => threads;

    /// <summary>Open file descriptors.</summary>
    public int Handles => handles;

    /// <summary>What the collector still reaches after a full collection.</summary>
    public long HeapBytes => heapBytes;

    /// <summary>Memory that the process really has.</summary>
    public long ResidentBytes => residentBytes;

    public static ProcessState Now()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        long heap = GC.GetTotalMemory(forceFullCollection: true);
        string[] status = File.ReadAllLines("/proc/self/status");
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
