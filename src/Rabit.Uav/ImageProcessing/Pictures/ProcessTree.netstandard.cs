using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Runtime.InteropServices;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Ends a program with all that it has started: what is left of them would keep its output open, and a reader waiting.
/// Those are found in <c>/proc</c>; where there is none, only the program itself is ended.
/// </summary>
internal static class ProcessTree
{
    // Of Linux, on every processor.
    private const int Sigkill = 9;
    private const int Sigstop = 19;

    /// <exception cref="InvalidOperationException">It has ended.</exception>
    public static void Kill(Process process)
    {
        if (!process.HasExited && File.Exists("/proc/self/stat"))
            KillTree(process.Id);
        process.Kill();
    }

    // Each is stopped before its children are looked up, else it starts one more after that.
    private static void KillTree(int root)
    {
        var found = new List<int> { root };
        for (int i = 0; i < found.Count; i++)
        {
            SendSignal(found[i], Sigstop);
            AddChildren(found[i], found);
        }

        foreach (int id in found)
            SendSignal(id, Sigkill);
    }

    private static void AddChildren(int ofParent, List<int> found)
    {
        foreach (string folder in Directory.GetDirectories("/proc"))
        {
            if (int.TryParse(Path.GetFileName(folder), NumberStyles.None, CultureInfo.InvariantCulture, out int id)
                && TryReadParent(folder, out int parent) && parent == ofParent)
                found.Add(id);
        }
    }

    // "12 (name) S 1 ...": the name may hold blanks and brackets.
    private static bool TryReadParent(string folder, out int parent)
    {
        parent = 0;
        try
        {
            string stat = File.ReadAllText(Path.Combine(folder, "stat"));
            string[] fields = stat.Substring(stat.LastIndexOf(')') + 1).Split(' ');
            return fields.Length > 2
                && int.TryParse(fields[2], NumberStyles.None, CultureInfo.InvariantCulture, out parent);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;   // it has ended, or is hidden from this user
        }
    }

    // No error is of use: it has ended, or runs as another user.
    [DllImport("libc", EntryPoint = "kill")]
    private static extern int SendSignal(int processId, int signal);
}
