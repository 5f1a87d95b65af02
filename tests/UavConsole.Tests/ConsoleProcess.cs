using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace UavConsole.Tests;

/// <summary>UavConsole as a user starts it: a process of its own, on the runtime that the tests run on.</summary>
internal sealed class ConsoleProcess : IDisposable
{
    public const int Interrupt = 2;
    public const int Terminate = 15;
    public const int KillNow = 9;

    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(150);   // on an idle machine
    private static readonly string Folder = Path.GetDirectoryName(typeof(ConsoleProcess).Assembly.Location)!;
    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    private readonly Process _process;
    private readonly object _gate = new();
    private readonly List<string> _output = [];
    private readonly List<string> _errors = [];
    private int _openStreams = 2;
    private string? _ownFolder;

    private ConsoleProcess(IEnumerable<string> arguments, string? workingFolder = null)
        : this(IsMono ? "mono" : "dotnet", Line(arguments), workingFolder)
    {
    }

    private ConsoleProcess(string program, string line, string? workingFolder)
    {
        _process = new Process
        {
            StartInfo = new ProcessStartInfo(program, line)
            {
                UseShellExecute = false,
                WorkingDirectory = workingFolder ?? OwnFolder(),
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                StandardOutputEncoding = Encoding.UTF8,
                StandardErrorEncoding = Encoding.UTF8,
            },
        };
        _process.OutputDataReceived += (_, e) => Take(_output, e.Data);
        _process.ErrorDataReceived += (_, e) => Take(_errors, e.Data);
        _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    public IReadOnlyList<string> Output
    {
        get
        {
            lock (_gate)
                return _output.ToArray();
        }
    }

    public IReadOnlyList<string> Errors
    {
        get
        {
            lock (_gate)
                return _errors.ToArray();
        }
    }

    /// <summary>The number of the process.</summary>
    public int Id => _process.Id;

    public static ConsoleProcess Start(params string[] arguments) => new(arguments);

    /// <summary>Starts it in a folder.</summary>
    public static ConsoleProcess StartIn(string workingFolder, params string[] arguments)
        => new(arguments, workingFolder);

    /// <summary>Starts it and waits for its end.</summary>
    public static ConsoleProcess Run(out int exitCode, params string[] arguments)
    {
        var process = new ConsoleProcess(arguments);
        exitCode = process.WaitForEnd();
        return process;
    }

    /// <summary>Starts it in a folder, and waits for its end.</summary>
    public static ConsoleProcess RunIn(string workingFolder, out int exitCode, params string[] arguments)
    {
        var process = new ConsoleProcess(arguments, workingFolder);
        exitCode = process.WaitForEnd();
        return process;
    }

    /// <summary>Starts it in a folder by the shell, with its output redirected, and waits for its end.</summary>
    public static int RunInShell(string workingFolder, string redirection, out string errors, params string[] arguments)
    {
        string line = $"{(IsMono ? "mono" : "dotnet")} {Line(arguments)} {redirection}";
        using var process = new ConsoleProcess("sh", $"-c \"{line.Replace("\"", "\\\"")}\"", workingFolder);
        int exitCode = process.WaitForEnd();
        errors = string.Join("\n", process.Errors);
        return exitCode;
    }

    private static string Line(IEnumerable<string> arguments)
        => string.Join(" ", new[] { Path.Combine(Folder, IsMono ? "UavConsole.exe" : "UavConsole.dll") }
            .Concat(arguments).Select(a => "\"" + a + "\""));

    /// <summary>Waits for a line that holds a text.</summary>
    public string WaitFor(string text)
    {
        lock (_gate)
        {
            var timeout = new TestTimeout(MaxWait);
            while (true)
            {
                if (_output.Find(l => l.Contains(text)) is { } line)
                    return line;
                if (_openStreams == 0 || !timeout.TryWait(_gate))
                    throw new TimeoutException($"No line holds '{text}'. {DescribeLocked()}");
            }
        }
    }

    /// <summary>Waits until it runs: managers started, signals handled.</summary>
    public void WaitForStart() => WaitFor("reactor: starts communications");

    public int WaitForEnd()
    {
        bool hasExited = _process.WaitForExit((int)TestTimeout.LimitOf(MaxWait).TotalMilliseconds);
        lock (_gate)
        {
            var timeout = new TestTimeout(MaxWait);
            while (hasExited && _openStreams > 0 && timeout.TryWait(_gate))
            {
                // What the process has written is still on its way.
            }

            Assert.True(hasExited, "It does not end. " + DescribeLocked());
            return _process.ExitCode;
        }
    }

    public void Signal(int signal) => Assert.Equal(0, Kill(_process.Id, signal));

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill();
        _process.Dispose();
        if (_ownFolder is not null)
            Directory.Delete(_ownFolder, recursive: true);
    }

    public override string ToString()
    {
        lock (_gate)
            return DescribeLocked();
    }

    [DllImport("libc", EntryPoint = "kill")]
    private static extern int Kill(int process, int signal);

    // What a run writes by default goes to the current folder.
    private string OwnFolder()
    {
        _ownFolder = Path.Combine(Path.GetTempPath(), "uavconsole-" + Guid.NewGuid().ToString("N"));
        return Directory.CreateDirectory(_ownFolder).FullName;
    }

    private void Take(List<string> lines, string? line)
    {
        lock (_gate)
        {
            if (line is null)
                _openStreams--;
            else
                lines.Add(line);
            Monitor.PulseAll(_gate);
        }
    }

    private string DescribeLocked()
        => "Output:\n" + string.Join("\n", _output) + "\nErrors:\n" + string.Join("\n", _errors);
}
