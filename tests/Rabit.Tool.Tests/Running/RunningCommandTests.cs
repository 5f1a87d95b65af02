using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Xunit;

namespace Rabit.Tool.Tests.Running;

/// <summary>rabit top, graph and echo on a program that runs, as plain lines and on a pseudo-terminal.</summary>
public sealed class RunningCommandTests
{
    [Fact]
    public void Top_Once_IsATableOfManagersQueuesAndMessages()
    {
        using var program = new WatchedProgram();

        ToolProcess tool = ToolProcess.Run("top", "--once", "--every", "300", "--folder", program.Sockets);

        Assert.Equal((0, 0), (tool.ExitCode, tool.Errors.Count));
        Assert.StartsWith($"watched ({Environment.ProcessId})  main 00:00:", tool.Output[0], StringComparison.Ordinal);
        Assert.Contains("woken by", tool.Output[1]);
        string[] ticker = Row(tool, "ticker");
        Assert.Equal("running", ticker[1]);
        Assert.InRange(double.Parse(ticker[2], System.Globalization.CultureInfo.InvariantCulture), 1, 60);
        Assert.Equal("timer", ticker[4]);
        Assert.Equal(["Int32", "2", "2", "2"], Row(tool, "numbers")[1..5]);
        Assert.Equal("Int32", Row(tool, "count")[1]);
        Assert.DoesNotContain('\u001b', tool.Text);
    }

    [Fact]
    public void Top_SortedAndFiltered_HasTheRowsThatAreAskedFor()
    {
        using var program = new WatchedProgram();

        ToolProcess tool = ToolProcess.Run(
            "top", "--once", "--every", "100", "--show", "managers", "--sort", "name", "--filter", "ER", "--folder",
            program.Sockets);

        Assert.Equal(["hoarder", "ticker"], tool.Output.Skip(2).Select(l => l.Split(' ')[0]));
    }

    [Fact]
    public void Graph_InEachFormat_IsTheWiring()
    {
        using var program = new WatchedProgram();
        Assert.StartsWith("flowchart", Graph(), StringComparison.Ordinal);
        Assert.StartsWith("digraph", Graph("--format", "dot"), StringComparison.Ordinal);
        Assert.Contains("queue numbers : Int32, 2 at most", Graph("--format", "text", "--program", "watched"));

        string Graph(params string[] options)
        {
            ToolProcess tool = ToolProcess.Run(["graph", "--folder", program.Sockets, .. options]);
            Assert.Equal(0, tool.ExitCode);
            return tool.Text;
        }
    }

    [Fact]
    public void Echo_SeveralValues_AreLinesOfJson()
    {
        using var program = new WatchedProgram();

        ToolProcess tool = ToolProcess.Run(
            "echo", "count", "--count", "3", "--every", "50", "--folder", program.Sockets);

        Assert.Equal(0, tool.ExitCode);
        int[] values = tool.Output
            .Select(l => JsonDocument.Parse(l).RootElement.GetProperty("value").GetInt32()).ToArray();
        Assert.Equal(3, values.Length);
        Assert.Equal(values.Order(), values);
    }

    [Fact]
    public void Echo_UnknownMessage_NamesThoseThatThereAreAndIsExitCode1()
    {
        using var program = new WatchedProgram();

        ToolProcess tool = ToolProcess.Run("echo", "cuont", "--folder", program.Sockets);

        Assert.Equal(1, tool.ExitCode);
        Assert.Equal("rabit echo: There is no message 'cuont'; there are: count.", Assert.Single(tool.Errors));
    }

    [Fact]
    public void Command_NoProgramRuns_SaysWhereItLooked()
    {
        ToolProcess tool = ToolProcess.Run("top", "--folder", "/nowhere");

        Assert.Equal(1, tool.ExitCode);
        Assert.Equal("rabit top: No program offers diagnostics in /nowhere.", Assert.Single(tool.Errors));
    }

    [Fact]
    public void Command_SeveralProgramsRun_NeedsOneByName()
    {
        using var one = new WatchedProgram("one");
        using var two = new WatchedProgram("two", one.Folder);

        ToolProcess several = ToolProcess.Run("graph", "--folder", one.Sockets);
        ToolProcess list = ToolProcess.Run("echo", "--list", "--folder", one.Sockets);
        ToolProcess second = ToolProcess.Run("graph", "--program", "two", "--folder", one.Sockets);

        Assert.Equal(2, several.ExitCode);
        Assert.Contains($"one ({Environment.ProcessId}), two ({Environment.ProcessId}); name one", several.Errors[0]);
        Assert.Equal(["one", "two"], list.Output.Select(l => l.Split(' ')[0]));
        Assert.Equal((0, 0, 0), (list.ExitCode, second.ExitCode, second.Errors.Count));
    }

    [Fact]
    public void Command_WrongOptions_AreExitCode2()
    {
        Assert.Equal(2, ToolProcess.Run("top", "--sort", "colour").ExitCode);
        Assert.Equal(2, ToolProcess.Run("top", "--count", "0").ExitCode);
        Assert.Equal(2, ToolProcess.Run("echo", "x", "--every", "9").ExitCode);
        Assert.Equal(2, ToolProcess.Run("echo", "--evrey", "9").ExitCode);
        Assert.Equal(2, ToolProcess.Run("graph", "--format", "png").ExitCode);
        using var program = new WatchedProgram();
        ToolProcess echo = ToolProcess.Run("echo", "--folder", program.Sockets);
        Assert.Equal(2, echo.ExitCode);
        Assert.Contains("name of a message is missing", echo.Errors[0]);
    }

    [TerminalFact]
    public void Top_OnATerminal_FollowsTheKeysAndTheEndOfTheProgram()
    {
        var program = new WatchedProgram();
        using var terminal = new TerminalProcess($"top --every 200 --folder {program.Sockets}");
        terminal.WaitFor("\u001b[?1049h");
        terminal.WaitFor("hoarder");
        terminal.Type("r");
        terminal.WaitFor("by rate");
        terminal.Type("/tick\r");
        terminal.WaitFor("filter: tick (Esc: none)");
        terminal.Type("2");
        program.Dispose();
        terminal.WaitFor("has ended; waiting for watched to start again");
        int before = terminal.Output.Length;
        Directory.CreateDirectory(program.Folder);
        using (new WatchedProgram("watched", program.Folder))
            terminal.WaitFor("by rate", before);
        terminal.Type("q");

        Assert.Equal(0, terminal.WaitForEnd());
        terminal.WaitFor("\u001b[?1049l");
        Directory.Delete(program.Folder, recursive: true);
    }

    [TerminalFact]
    public void Top_OnATerminalThatSendsCtrlC_GivesTheTerminalBack()
    {
        using var program = new WatchedProgram();
        using var terminal = new TerminalProcess($"top --every 200 --folder {program.Sockets}");
        terminal.WaitFor("hoarder");

        terminal.Type("\u0003");

        Assert.Equal(130, terminal.WaitForEnd());
        terminal.WaitFor("\u001b[?1049l");
    }

    // The words of the row of a manager, queue or message.
    private static string[] Row(ToolProcess tool, string name)
        => tool.Output.Single(l => l.StartsWith(name + " ", StringComparison.Ordinal))
            .Split(' ', StringSplitOptions.RemoveEmptyEntries);
}
