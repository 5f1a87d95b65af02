using System;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Rabit.Core.Tests.Locks;

/// <summary>What the kernel says of a thread of this process (man 5 proc).</summary>
/// <param name="id">The kernel's id.</param>
internal sealed class KernelThread(int id)
{
    private readonly string _folder = FormattableString.Invariant($"/proc/self/task/{id}/");

    public int Id => id;

    /// <summary>"For processes running a real-time scheduling policy, the negated priority, minus one".</summary>
    public int Priority
    {
        get
        {
            string text = File.ReadAllText(_folder + "stat");
            const int FieldAfterName = 15;   // the 18th; the second, a name in brackets, may have spaces
            string[] fields = text.Substring(text.LastIndexOf(')') + 2).Split(' ');
            return int.Parse(fields[FieldAfterName], CultureInfo.InvariantCulture);
        }
    }

    /// <summary>
    /// How often it has gone to sleep by itself: once more where a sleep in the kernel was interrupted.
    /// </summary>
    public long Sleeps
    {
        get
        {
            const string Name = "voluntary_ctxt_switches:";
            string line = File.ReadLines(_folder + "status").Single(
                l => l.StartsWith(Name, StringComparison.Ordinal));
            return long.Parse(line.Split(':')[1], CultureInfo.InvariantCulture);
        }
    }

    /// <summary>Whether it sleeps in a futex call with this operation.</summary>
    public bool IsInFutex(int operation)
        => File.ReadAllText(_folder + "syscall").Split(' ') is { Length: > 2 } words
            && words[2] == FormattableString.Invariant($"0x{operation:x}");
}
