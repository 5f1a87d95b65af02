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

namespace UavService.Tests;

/// <summary>The service as systemd starts it: a process of its own, in a folder with its settings.</summary>
internal sealed class ServiceProcess : IDisposable
{
    public const int Terminate = 15;

    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(120);   // on an idle machine
    private static readonly string Program = Path.Combine(AppContext.BaseDirectory, "UavService.dll");

    private readonly StringBuilder _output = new();   // locked by itself
    private readonly StringBuilder _errors = new();
    private readonly Process _process;

    /// <param name="settings">What is in appsettings.json; null for no such file.</param>
    /// <param name="notifySocket">For NOTIFY_SOCKET; null for none.</param>
    /// <param name="arguments">On the command line.</param>
    public ServiceProcess(string? settings, string? notifySocket, params string[] arguments)
    {
        Folder = Directory.CreateTempSubdirectory("uav-service-").FullName;
        if (settings is not null)
            File.WriteAllText(Path.Combine(Folder, "appsettings.json"), settings);
        var start = new ProcessStartInfo("dotnet", arguments.Prepend(Program))
        {
            WorkingDirectory = Folder,
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment.Remove("NOTIFY_SOCKET");
        start.Environment.Remove("WATCHDOG_USEC");
        if (notifySocket is not null)
            start.Environment["NOTIFY_SOCKET"] = notifySocket;
        _process = Process.Start(start)!;
        _process.OutputDataReceived += (_, e) => Take(_output, e.Data);
        _process.ErrorDataReceived += (_, e) => Take(_errors, e.Data);
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    public string Folder { get; }

    /// <summary>Standard output so far.</summary>
    public string Output => Read(_output);

    /// <summary>Standard error so far.</summary>
    public string Errors => Read(_errors);

    /// <summary>Waits until its output holds a text.</summary>
    public void WaitFor(string text)
    {
        var timeout = new TestTimeout(MaxWait);
        lock (_output)
        {
            while (!_output.ToString().Contains(text, StringComparison.Ordinal))
            {
                Assert.True(
                    !_process.HasExited && timeout.TryWait(_output), $"No '{text}' in:\n{_output}\n{Errors}");
            }
        }
    }

    public int Stop()
    {
        Assert.Equal(0, Kill(_process.Id, Terminate));
        return WaitForEnd();
    }

    /// <returns>The exit code.</returns>
    public int WaitForEnd()
    {
        Assert.True(_process.WaitForExit(TestTimeout.LimitOf(MaxWait)), "It does not end:\n" + Output + Errors);
        _process.WaitForExit();   // also for all that it has written
        return _process.ExitCode;
    }

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill();
        _process.Dispose();
        Directory.Delete(Folder, recursive: true);
    }

    [DllImport("libc", EntryPoint = "kill")]
    private static extern int Kill(int process, int signal);

    private static string Read(StringBuilder text)
    {
        lock (text)
            return text.ToString();
    }

    private static void Take(StringBuilder text, string? line)
    {
        lock (text)
        {
            if (line is not null)
                text.Append(line).Append('\n');
            Monitor.PulseAll(text);
        }
    }
}
