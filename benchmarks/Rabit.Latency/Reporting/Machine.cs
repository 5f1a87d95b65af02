using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using Rabit.Latency.Native;

namespace Rabit.Latency.Reporting;

/// <summary>What the figures were measured on.</summary>
internal static class Machine
{
    public static bool IsMono { get; } = Type.GetType("Mono.Runtime") is not null;

    public static string Runtime => IsMono ? "Mono" : ".NET";

    public static string Describe()
        => $"{RuntimeInformation.FrameworkDescription}, {RuntimeInformation.ProcessArchitecture}, {Cpus.Allowed.Count} "
            + $"CPUs ({Processor()}), {Kernel()}, "
            + $"load {FirstWord("/proc/loadavg")} at the start";

    private static string Processor()
    {
        const string Label = "model name";
        string? line = File.ReadLines("/proc/cpuinfo")
            .FirstOrDefault(l => l.StartsWith(Label, StringComparison.Ordinal));
        return line is null ? "unnamed" : line.Substring(line.IndexOf(':') + 1).Trim();
    }

    private static string Kernel() => "Linux " + File.ReadAllText("/proc/sys/kernel/osrelease").Trim();

    private static string FirstWord(string file) => File.ReadAllText(file).Split(' ')[0];
}
