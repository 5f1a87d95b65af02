using System;
using System.CommandLine;
using System.Linq;
using Xunit;

namespace Rabit.Tool.Tests;

/// <summary>What all commands share: help, version, and what is said of a command line that makes no sense.</summary>
public sealed class CommandLineTests
{
    [Fact]
    public void Help_NamesEveryCommand()
    {
        ToolProcess tool = ToolProcess.Run("--help");

        Assert.Equal((0, 0), (tool.ExitCode, tool.Errors.Count));
        Assert.All(CommandLine.Create().Subcommands, c => Assert.Contains("  " + c.Name, tool.Text));
    }

    [Fact]
    public void Version_IsThatOfThePackage()
    {
        ToolProcess tool = ToolProcess.Run("--version");

        Assert.Equal(0, tool.ExitCode);
        Assert.Equal(typeof(CommandLine).Assembly.GetName().Version!.ToString(3), Assert.Single(tool.Output));
    }

    [Fact]
    public void Descriptions_OfAllCommandsAndOptions_AreSentences()
        => Assert.All(
            CommandLine.Create().Subcommands,
            (Command c) =>
            {
                Assert.EndsWith(".", c.Description, StringComparison.Ordinal);
                Assert.All(c.Options, o => Assert.EndsWith(".", o.Description, StringComparison.Ordinal));
                Assert.All(c.Arguments, a => Assert.EndsWith(".", a.Description, StringComparison.Ordinal));
            });

    [Theory]
    [InlineData("mavlnk FILE --print", "rabit: 'mavlnk' is no command; did you mean 'mavlink'?")]
    [InlineData("geo", "rabit: 'geo' is no command.")]
    [InlineData("simulate --wnid 3", "rabit simulate: '--wnid' is no option; did you mean '--wind'?")]
    [InlineData("--cvs", "rabit: '--cvs' is no option.")]
    [InlineData("completion tcsh", "rabit completion: 'tcsh' is no shell that has completion; there are bash, ")]
    [InlineData("simulate --seed", "rabit simulate: Required argument missing for option: '--seed'.")]
    [InlineData("mavlink ", "rabit mavlink: FILE is empty.")]
    [InlineData("geolocate camera.json ", "rabit geolocate: REQUEST is empty.")]
    [InlineData("mavlink \u001b[2J", "rabit mavlink: .[2J: no such file.")]
    [InlineData("mavlink a\nb", "rabit mavlink: a b: no such file.")]
    [InlineData("mavlink @FILE", "rabit mavlink: @FILE: no such file.")]
    public void Run_MistypedWord_IsOneLineWithAGuess(string line, string expected)
    {
        ToolProcess tool = ToolProcess.Run(line.Split(' '));

        Assert.Equal((2, 0), (tool.ExitCode, tool.Output.Count));
        Assert.StartsWith(expected, Assert.Single(tool.Errors), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_NothingAsked_IsTheHelpAndExitCode2()
    {
        ToolProcess tool = ToolProcess.Run();

        Assert.Equal((2, 0), (tool.ExitCode, tool.Output.Count));
        Assert.Contains("Usage:", tool.Errors.Select(l => l.Trim()));
    }
}
