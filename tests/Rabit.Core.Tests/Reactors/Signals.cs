using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;

namespace Rabit.Core.Tests.Reactors;

/// <summary>Unix signals, for tests that send real ones.</summary>
internal static class Signals
{
    public const int HangUp = 1;
    public const int Interrupt = 2;
    public const int Quit = 3;
    public const int Terminate = 15;

    public const string WhyIgnored =
        "This process was started to ignore the signal, as a shell does it for what runs in its background.";

    public static int OwnProcess => GetPid();

    public static int Send(int process, int signal) => Kill(process, signal);

    /// <summary>Whether this process, and so what it starts, ignores a signal, as far as Linux says.</summary>
    public static bool IsIgnored(int signal)
    {
        const string Status = "/proc/self/status";
        if (signal == 0 || !File.Exists(Status))
            return false;
        string line = File.ReadLines(Status).First(l => l.StartsWith("SigIgn:", StringComparison.Ordinal));
        ulong mask = ulong.Parse(
            line.Substring(line.IndexOf(':') + 1).Trim(), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        return (mask >> (signal - 1) & 1) != 0;
    }

    [DllImport("libc", EntryPoint = "getpid")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int GetPid();

    [DllImport("libc", EntryPoint = "kill")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Kill(int process, int signal);
}
