using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Text;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A program whose standard output is read, and that ends with this one: it is killed, with what it has started, when
/// this is disposed or the process exits; if that is killed itself, by its <see cref="OrphanWatch"/>. Where there is
/// none, its pipe breaks then, which ends a program that writes.
/// </summary>
internal sealed class ChildProcess : IDisposable
{
    // ENOENT and ERROR_FILE_NOT_FOUND; EACCES.
    private const int NoSuchFile = 2;
    private const int NotPermitted = 13;

    private const int MaxEndMs = 1_000;

    private readonly Process _process;
    private readonly EventHandler _onExit;
    private readonly OrphanWatch? _watch;
    private readonly ErrorLines _errors;

    /// <exception cref="IOException">It cannot be started; the text says why, without its name.</exception>
    public ChildProcess(string program, IReadOnlyList<string> arguments, Action<string> onErrorLine)
    {
        _process = new Process
        {
            StartInfo = new ProcessStartInfo(program, Quote(arguments))
            {
                UseShellExecute = false,
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                CreateNoWindow = true,
            },
        };
        _onExit = (_, _) => Kill();
        try
        {
            _process.Start();
        }
        catch (Exception e) when (e is Win32Exception or IOException or InvalidOperationException)
        {
            _process.Dispose();
            throw new IOException(ReasonOf(e), e);
        }

        _watch = OrphanWatch.TryStart(_process.Id);
        AppDomain.CurrentDomain.ProcessExit += _onExit;
        _process.StandardInput.Dispose();   // else it may take keys that are meant for this program
        _errors = new ErrorLines(_process.StandardError.BaseStream, onErrorLine);
        Output = _process.StandardOutput.BaseStream;
    }

    public Stream Output { get; }

    /// <summary>How it ended, for people; what it wrote to its errors was passed on before.</summary>
    public string DescribeEnd()
    {
        bool hasEnded = _process.WaitForExit(MaxEndMs);
        if (hasEnded)
            _errors.TryWait(MaxEndMs);   // a program that it has started may go on, and keep them open
        return hasEnded ? $"it ended with exit code {_process.ExitCode}" : "it closed its output";
    }

    /// <summary>Ends it; from any thread, also when it has ended.</summary>
    public void Kill()
    {
        try
        {
            ProcessTree.Kill(_process);
        }
        catch (Exception e) when (e is InvalidOperationException or Win32Exception or NotSupportedException)
        {
            // It has ended.
        }
    }

    public void Dispose()
    {
        AppDomain.CurrentDomain.ProcessExit -= _onExit;
        Kill();
        _watch?.Dispose();
        _errors.Dispose();
        Output.Dispose();   // which the process leaves to those who have asked for it
        _process.Dispose();
    }

    // The runtimes name it in different ways, some with the working folder, which has nothing to do with it.
    private static string ReasonOf(Exception e) => e is Win32Exception { NativeErrorCode: NoSuchFile }
        ? "there is no such program"
        : e is Win32Exception { NativeErrorCode: NotPermitted }
            ? "it cannot be started: it is no program, or this user may not run it"
            : "it cannot be started: " + e.Message;

    // As the runtime takes them apart again on every system: a quote is \", and so many \ before it twice.
    internal static string Quote(IReadOnlyList<string> arguments)
    {
        var line = new StringBuilder();
        foreach (string argument in arguments)
        {
            line.Append(line.Length == 0 ? "\"" : " \"");
            int slashes = 0;
            foreach (char character in argument)
            {
                if (character == '"')
                    line.Append('\\', slashes + 1);
                slashes = character == '\\' ? slashes + 1 : 0;
                line.Append(character);
            }

            line.Append('\\', slashes).Append('"');
        }

        return line.ToString();
    }
}
