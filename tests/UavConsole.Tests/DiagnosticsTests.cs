using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The socket by which the tool "rabit" looks into a flight, on .NET.</summary>
public sealed class DiagnosticsTests
{
    [Fact]
    public void Run_OnDotNet_HasASocketWhileItLasts()
    {
        bool isMono = Type.GetType("Mono.Runtime") is not null;
        using ConsoleProcess console = ConsoleProcess.Start("--realtime", "--headless");
        console.WaitForStart();

        Assert.Equal(isMono ? 0 : 1, CountSockets(console.Id));
        console.Signal(ConsoleProcess.Interrupt);
        console.WaitForEnd();
        Assert.Equal(0, CountSockets(console.Id));
    }

    private static int CountSockets(int process)
    {
        string suffix = "-" + process.ToString(CultureInfo.InvariantCulture) + ".sock";
        string? session = Environment.GetEnvironmentVariable("XDG_RUNTIME_DIR");
        return Directory.GetDirectories("/tmp", "rabit-*")
            .Concat(string.IsNullOrEmpty(session) ? [] : new[] { Path.Combine(session, "rabit") })
            .Count(folder => File.Exists(Path.Combine(folder, "UavConsole" + suffix)));
    }
}
