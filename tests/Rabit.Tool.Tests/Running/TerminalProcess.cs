using System;
using System.Diagnostics;
using System.IO;
using System.Text;
using System.Threading;
using Rabit.Tests.Shared;

namespace Rabit.Tool.Tests.Running;

/// <summary>The tool on a pseudo-terminal of 110 columns and 24 lines, which the program script makes.</summary>
internal sealed class TerminalProcess : IDisposable
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(100);   // on an idle machine

    private readonly Process _process;
    private readonly object _gate = new();
    private readonly StringBuilder _output = new();   // under _gate

    public TerminalProcess(string arguments)
    {
        var start = new ProcessStartInfo("script")
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            StandardOutputEncoding = Encoding.UTF8,
        };
        start.ArgumentList.Add("-qec");
        start.ArgumentList.Add($"stty cols 110 rows 24; {ToolProcess.Command} {arguments}");
        start.ArgumentList.Add("/dev/null");
        start.Environment["TERM"] = "xterm-256color";
        _process = Process.Start(start)!;
        new Thread(Read) { IsBackground = true }.Start();
    }

    /// <summary>All that was written to the terminal.</summary>
    public string Output
    {
        get
        {
            lock (_gate)
                return _output.ToString();
        }
    }

    public static bool IsPossible => File.Exists("/usr/bin/script");

    public void Type(string keys)
    {
        _process.StandardInput.Write(keys);
        _process.StandardInput.Flush();
    }

    /// <summary>Waits until a text was written, at a place or after it.</summary>
    public void WaitFor(string text, int from = 0)
    {
        var timeout = new TestTimeout(MaxWait);
        lock (_gate)
        {
            while (_output.ToString().IndexOf(text, from, StringComparison.Ordinal) < 0)
            {
                if (!timeout.TryWait(_gate))
                    throw new TimeoutException($"There is no '{text}' in: {_output}");
            }
        }
    }

    /// <returns>The exit code.</returns>
    public int WaitForEnd()
    {
        if (!_process.WaitForExit(TestTimeout.LimitOf(MaxWait)))
            throw new TimeoutException($"It does not end: {Output}");
        return _process.ExitCode;
    }

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill(entireProcessTree: true);
        _process.Dispose();
    }

    private void Read()
    {
        var buffer = new char[4096];
        try
        {
            while (_process.StandardOutput.Read(buffer, 0, buffer.Length) is var count and > 0)
            {
                lock (_gate)
                {
                    _output.Append(buffer, 0, count);
                    Monitor.PulseAll(_gate);
                }
            }
        }
        catch (Exception e) when (e is IOException or InvalidOperationException)
        {
            // The test is over.
        }
    }
}
