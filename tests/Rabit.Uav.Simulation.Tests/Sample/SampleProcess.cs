using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Sample;

/// <summary>A program as a user starts it: a process of its own, on the runtime that the tests run on.</summary>
internal sealed class SampleProcess : IDisposable
{
    private const int InterruptSignal = 2;

    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(60);   // on an idle machine

    private static readonly string Folder = Path.GetDirectoryName(typeof(SampleProcess).Assembly.Location)!;
    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    private readonly Process _process;
    private readonly List<string> _lines = [];   // locked by itself

    public SampleProcess(string program, params string[] arguments)
    {
        IEnumerable<string> all = new[] { Path.Combine(Folder, program + (IsMono ? ".exe" : ".dll")) }
            .Concat(arguments);
        _process = new Process
        {
            StartInfo = new ProcessStartInfo(
                IsMono ? "mono" : "dotnet", string.Join(" ", all.Select(a => "\"" + a + "\"")))
            {
                UseShellExecute = false,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            },
        };
        _process.OutputDataReceived += (_, e) => Take(e.Data);
        _process.ErrorDataReceived += (_, e) => Take(e.Data);
        _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    public string Output
    {
        get
        {
            lock (_lines)
                return string.Join("\n", _lines);
        }
    }

    public bool HasEnded => _process.HasExited;

    /// <summary>Whether it ends by itself within a time, which should be short.</summary>
    public bool EndsWithin(TimeSpan time) => _process.WaitForExit((int)time.TotalMilliseconds);

    /// <summary>Waits until something is so; fails the test if the process ends before, or takes too long.</summary>
    public void WaitUntil(Func<bool> condition)
    {
        // In turns: some conditions come true without a line of output, such as a file that is there.
        var timeout = new TestTimeout(MaxWait);
        lock (_lines)
        {
            while (!condition())
                Assert.True(!HasEnded && timeout.TryWait(_lines), Output);
        }
    }

    /// <summary>Ctrl-C.</summary>
    public void Interrupt() => Assert.Equal(0, Kill(_process.Id, InterruptSignal));

    public int WaitForEnd(TimeSpan? timeout = null)
    {
        Assert.True(
            _process.WaitForExit((int)(timeout ?? TestTimeout.LimitOf(MaxWait)).TotalMilliseconds),
            "it does not end: " + Output);
        _process.WaitForExit();
        return _process.ExitCode;
    }

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill();
        _process.Dispose();
    }

    private void Take(string? line)
    {
        if (line is null)
            return;
        lock (_lines)
        {
            _lines.Add(line);
            Monitor.PulseAll(_lines);
        }
    }

    [DllImport("libc", EntryPoint = "kill")]
    private static extern int Kill(int process, int signal);
}
