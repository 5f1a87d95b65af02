using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Tests;
using Rabit.Uav.Simulation.Tests.Sample;
using Xunit;

namespace Rabit.Tool.Tests;

/// <summary>What a terminal, a pipe, a full disk and Ctrl-C do to a command.</summary>
public sealed class TerminalTests : IDisposable
{
    private const string ShowCursor = "\u001b[?25h";
    private const string HideCursor = "\u001b[?25l";
    private const int LargeLogCopies = 14;

    private static readonly string Flight = TestData.PathOf("px4-flight.tlog");

    private readonly string _folder =
        Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), "rabit-tool-" + Guid.NewGuid().ToString("N")))
            .FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Mavlink_LargeLogInATerminal_ShowsProgressAndLeavesTheTableAlone()
    {
        ToolProcess tool = InTerminal($"{ToolProcess.Command} mavlink \"{LargeLog()}\"");

        Assert.Equal(0, tool.ExitCode);
        Assert.Contains("reading", tool.Text);
        Assert.Contains("%", tool.Text);
        Assert.True(tool.Text.LastIndexOf(ShowCursor, StringComparison.Ordinal)
            > tool.Text.LastIndexOf(HideCursor, StringComparison.Ordinal), "The cursor stays away.");
        Assert.StartsWith(
            "HEARTBEAT", tool.Output.First(l => l.Contains("HEARTBEAT")), StringComparison.Ordinal);
    }

    [Fact]
    public void Mavlink_LargeLogWithoutATerminal_PrintsPlainLinesOnly()
    {
        ToolProcess tool = ToolProcess.Run("mavlink", LargeLog());

        Assert.Equal((0, 0), (tool.ExitCode, tool.Errors.Count));
        Assert.DoesNotContain(tool.Text, c => char.IsControl(c) && c != '\n');
    }

    [Fact]
    public void Help_InATerminal_IsWithinItsWidth()
    {
        ToolProcess tool = InTerminal($"stty cols 80; {ToolProcess.Command} geolocate --help");

        Assert.Equal(0, tool.ExitCode);
        Assert.All(tool.Output, line => Assert.InRange(line.Length, 0, 80));
    }

    [Theory]
    [InlineData("mavlink --print")]
    [InlineData("mavlink --json")]
    [InlineData("mavlink")]
    public void Mavlink_ReaderThatEndsEarly_EndsWithoutAWord(string command)
    {
        ToolProcess tool = ToolProcess.RunInShell(
            $"rabit {command} \"{LargeLog()}\" | head -n 1; exit ${{PIPESTATUS[0]}}", "bash");

        Assert.Equal((0, 1, 0), (tool.ExitCode, tool.Output.Count, tool.Errors.Count));
    }

    [Theory]
    [InlineData("mavlink --print FLIGHT", "rabit mavlink: the output cannot be written: ")]
    [InlineData("mavlink FLIGHT", "rabit mavlink: the output cannot be written: ")]
    [InlineData("completion bash", "rabit completion: the output cannot be written: ")]
    public void Output_FullDisk_IsOneLineAndExitCode2(string command, string expected)
    {
        if (!File.Exists("/dev/full"))
            return;
        ToolProcess tool = ToolProcess.RunInShell(
            $"rabit {command.Replace("FLIGHT", "\"" + Flight + "\"")} > /dev/full");

        Assert.Equal(2, tool.ExitCode);
        Assert.StartsWith(expected, Assert.Single(tool.Errors), StringComparison.Ordinal);
    }

    [Fact]
    public void Mavlink_CtrlCWhileItWaitsForAPipe_EndsBehindAWholeLine()
    {
        string pipe = Path.Combine(_folder, "pipe");
        Assert.Equal(0, ToolProcess.RunInShell($"mkfifo \"{pipe}\"").ExitCode);
        using var tool = new SampleProcess("Rabit.Tool", "mavlink", pipe, "--json", "--message", "HEARTBEAT");
        using var log = new FileStream(pipe, FileMode.Open, FileAccess.Write);
        byte[] flight = File.ReadAllBytes(Flight);
        log.Write(flight, 0, flight.Length);
        log.Flush();
        tool.WaitUntil(() => tool.Output.Count(c => c == '\n') > 50);

        tool.Interrupt();

        Assert.Equal(130, tool.WaitForEnd());
        Assert.All(tool.Output.Split('\n'), line => JsonDocument.Parse(line).Dispose());
    }

    private static ToolProcess InTerminal(string line)
        => ToolProcess.RunInShell(
            $"TERM=xterm script -qec '{line}' /dev/null < /dev/null");

    private string LargeLog()
    {
        string path = Path.Combine(_folder, "large.tlog");
        byte[] flight = File.ReadAllBytes(Flight);
        using FileStream file = File.Create(path);
        for (int copy = 0; copy < LargeLogCopies; copy++)
            file.Write(flight, 0, flight.Length);
        return path;
    }
}
