using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Tool.Tests;

/// <summary>The tool as a user starts it: a process of its own, on the runtime that the tests run on.</summary>
internal sealed class ToolProcess
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(100);   // on an idle machine
    private static readonly string Folder = Path.GetDirectoryName(typeof(ToolProcess).Assembly.Location)!;
    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    private static readonly string Runtime = IsMono ? "mono" : "dotnet";

    private static readonly string Program =
        "\"" + Path.Combine(Folder, IsMono ? "Rabit.Tool.exe" : "Rabit.Tool.dll") + "\"";

    private ToolProcess(int exitCode, string output, string errors)
    {
        ExitCode = exitCode;
        Text = output;
        Output = Lines(output);
        Errors = Lines(errors);
    }

    /// <summary>What starts it, for a shell: the runtime and the program.</summary>
    public static string Command => Runtime + " " + Program;

    public int ExitCode { get; }

    /// <summary>All of the output, as it is.</summary>
    public string Text { get; }

    /// <summary>The lines that are not empty.</summary>
    public IReadOnlyList<string> Output { get; }

    public IReadOnlyList<string> Errors { get; }

    /// <summary>Starts it and waits for its end.</summary>
    public static ToolProcess Run(params string[] arguments)
    {
        string line = string.Join(" ", arguments.Select(a => "\"" + a.Replace("\"", "\\\"") + "\""));
        return Start(Runtime, Program + " " + line);
    }

    /// <summary>Has a shell run a line, in which <c>rabit</c> stands for the tool, and waits for its end.</summary>
    public static ToolProcess RunInShell(string line, string shell = "sh")
    {
        string script = Path.Combine(Path.GetTempPath(), "rabit-tool-" + Guid.NewGuid().ToString("N") + ".sh");
        File.WriteAllText(script, "rabit() { " + Command + " \"$@\"; }\n" + line + "\n");
        try
        {
            return Start(shell, script);
        }
        finally
        {
            File.Delete(script);
        }
    }

    private static ToolProcess Start(string program, string arguments)
    {
        using var process = new Process
        {
            StartInfo = new ProcessStartInfo(program, arguments)
            {
                UseShellExecute = false,
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                StandardOutputEncoding = Encoding.UTF8,
                StandardErrorEncoding = Encoding.UTF8,
            },
        };
        process.Start();
        process.StandardInput.Close();
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        Task<string> errors = process.StandardError.ReadToEndAsync();
        if (!process.WaitForExit((int)TestTimeout.LimitOf(MaxWait).TotalMilliseconds))
        {
            process.Kill();
            Assert.Fail($"{program} {arguments} does not end.");
        }

        Task.WaitAll(output, errors);
        return new ToolProcess(process.ExitCode, output.Result, errors.Result);
    }

    private static string[] Lines(string text)
        => text.Split(['\n'], StringSplitOptions.RemoveEmptyEntries).Select(line => line.TrimEnd('\r')).ToArray();
}
