using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using Xunit;

namespace Rabit.Mavlink.Tests.MavlinkDump;

/// <summary>MavlinkDump as a user starts it: a process of its own, on the runtime that the tests run on.</summary>
internal sealed class DumpProcess
{
    private static readonly TimeSpan TimeLimit = TimeSpan.FromSeconds(60);
    private static readonly string Folder = Path.GetDirectoryName(typeof(DumpProcess).Assembly.Location)!;
    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    private DumpProcess(int exitCode, string output, string errors)
    {
        ExitCode = exitCode;
        Output = Lines(output);
        Errors = Lines(errors);
    }

    public int ExitCode { get; }

    public IReadOnlyList<string> Output { get; }

    public IReadOnlyList<string> Errors { get; }

    /// <summary>Starts it and waits for its end.</summary>
    public static DumpProcess Run(params string[] arguments)
    {
        IEnumerable<string> all = new[] { Path.Combine(Folder, IsMono ? "MavlinkDump.exe" : "MavlinkDump.dll") }
            .Concat(arguments);
        using var process = new Process
        {
            StartInfo = new ProcessStartInfo(
                IsMono ? "mono" : "dotnet", string.Join(" ", all.Select(argument => "\"" + argument + "\"")))
            {
                UseShellExecute = false,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                StandardOutputEncoding = Encoding.UTF8,
                StandardErrorEncoding = Encoding.UTF8,
            },
        };
        process.Start();
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        Task<string> errors = process.StandardError.ReadToEndAsync();
        if (!process.WaitForExit((int)TimeLimit.TotalMilliseconds))
        {
            process.Kill();
            Assert.Fail("It does not end.");
        }

        Task.WaitAll(output, errors);
        return new DumpProcess(process.ExitCode, output.Result, errors.Result);
    }

    private static string[] Lines(string text)
        => text.Split(['\n'], StringSplitOptions.RemoveEmptyEntries).Select(line => line.TrimEnd('\r')).ToArray();
}
