using System;
using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Ends a program, with what it has started, once this process was killed and can no longer do it: a shell waits for
/// the end of a pipe that only this process holds, which the system closes however it ends. On Linux with
/// <c>/bin/sh</c>; elsewhere there is none. What the program has started is found where the kernel lists children
/// (CONFIG_PROC_CHILDREN, as that of Debian does); else the program alone is ended.
/// </summary>
/// <remarks>
/// The parent-death signal of Linux would need no second process, but is sent at the end of the thread that started
/// the program, has to be set between fork and exec, and does not reach what the program has started.
/// </remarks>
internal sealed class OrphanWatch : IDisposable
{
    private const string Shell = "/bin/sh";

    // A number of a process may be given to another one: by its time of start, the 20th field after the name, it is
    // the same. Signals to the whole group or service, as by Ctrl-C, are for this process to act on.
    private const string Script = """
        trap '' HUP INT QUIT TERM
        exec >/dev/null 2>&1
        find() { at=; read -r line </proc/$1/stat || return 1; set -- ${line##*) }; at=${20}; }
        end() {
          kill -STOP $1
          for child in $(cat /proc/$1/task/*/children); do end $child; done
          kill -KILL $1
        }
        find $1 || exit
        first=$at
        read -r line
        find $1 && [ $at = $first ] && end $1
        """;

    private readonly Process _shell;

    private OrphanWatch(Process shell) => _shell = shell;

    /// <returns>Null where the system has not what it takes.</returns>
    public static OrphanWatch? TryStart(int processId)
    {
        if (!OperatingSystem.IsLinux() || !File.Exists(Shell))
            return null;
        var shell = new Process
        {
            StartInfo = new ProcessStartInfo(
                Shell,
                ChildProcess.Quote(
                    ["-c", Script.Replace("\r", ""), "rabit-watch", processId.ToString(CultureInfo.InvariantCulture)]))
            {
                UseShellExecute = false,
                RedirectStandardInput = true,

                // Not used; else the runtime takes it for a program that has the terminal, and sets that up for it.
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            },
        };
        try
        {
            shell.Start();
            return new OrphanWatch(shell);
        }
        catch (Exception e) when (e is Win32Exception or IOException or InvalidOperationException)
        {
            shell.Dispose();
            return null;
        }
    }

    /// <summary>Ends the watch. Call it when the program has ended.</summary>
    public void Dispose()
    {
        try
        {
            _shell.Kill();
        }
        catch (Exception e) when (e is InvalidOperationException or Win32Exception)
        {
            // It has ended.
        }

        _shell.Dispose();
    }
}
