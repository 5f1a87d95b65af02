using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Soak;

/// <summary>
/// Starts, runs and stops workspaces, four at a time, on both engines, and looks whether the process holds ever more
/// threads, handles or memory.
/// </summary>
internal static class SoakMode
{
    private const int AtOnce = 4;
    private const int LinesShown = 20;

    private static readonly List<object> Leaked = [];

    /// <returns>Whether everything stayed flat.</returns>
    public static bool Run(RunOptions options, TextWriter output)
    {
        double seconds = options.IsQuick ? 2 : options.SoakMinutes * 60;
        TimeSpan each = TimeSpan.FromMilliseconds(options.Pick(20, 200));
        output.WriteLine(string.Format(
            CultureInfo.InvariantCulture, "\nsoak: {0:0} s, {1} workspaces of eight managers at a time, {2} ms each",
            seconds, AtOnce, each.TotalMilliseconds));
        output.WriteLine("   seconds  workspaces      units of work   threads   handles   heap kB     RSS kB");
        var states = new List<ProcessState>();
        long start = MonotonicClock.Now;
        long runs = 0;
        int workspaces = 0;
        double nextLine = 0;
        for (double now = 0; now < seconds || states.Count < 9; now = (MonotonicClock.Now - start) / 1e9)
        {
            runs += RunSome(each, states.Count);
            workspaces += AtOnce;
            if (options.PlantsLeak)
                Leak();
            states.Add(ProcessState.WhenSettled());
            if (now >= nextLine)
            {
                Line(output, now, workspaces, runs, states[states.Count - 1]);
                nextLine += seconds / LinesShown;
            }
        }

        IReadOnlyList<string> grown = FlatnessCheck.Grown(states);
        output.WriteLine(
            grown.Count == 0 ? "  flat: nothing is left behind" : "  NOT flat: " + string.Join("; ", grown));
        return grown.Count == 0;
    }

    private static long RunSome(TimeSpan duration, int turn)
    {
        var runs = new long[AtOnce];
        Exception? failure = null;
        Thread[] threads = [.. Enumerable.Range(0, AtOnce).Select(i => new Thread(() =>
        {
            try
            {
                runs[i] = new SoakWorkspace((turn + i) % 2 == 0 ? WaitEngine.Futex : WaitEngine.Event).Run(duration);
            }
            catch (Exception e)
            {
                // It ends the soak.
                failure = e;
            }
        }))];
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();
        return failure is null ? runs.Sum() : throw new InvalidOperationException("A workspace failed.", failure);
    }

    private static void Line(TextWriter output, double now, int workspaces, long runs, ProcessState state)
        => output.WriteLine(string.Format(
            CultureInfo.InvariantCulture,
            "  {0,8:0.0} {1,11} {2,18} {3,9} {4,9} {5,9} {6,10}",
            now,
            workspaces,
            runs,
            state.Threads,
            state.Handles,
            state.HeapBytes / 1024,
            state.ResidentBytes / 1024));

    // What a library does that does not clean up.
    private static void Leak()
    {
        Leaked.Add(new byte[200_000]);
        Leaked.Add(File.OpenRead("/proc/self/status"));
        new Thread(() => Thread.Sleep(Timeout.Infinite)) { IsBackground = true }.Start();
    }
}
