using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Tool.Tests;

/// <summary>What bash completes, asked of the script itself; and that the other scripts are there.</summary>
public sealed class CompletionTests
{
    [Theory]
    [InlineData("rabit ", "completion,geolocate,mavlink,simulate,train")]
    [InlineData("rabit mav", "mavlink")]
    [InlineData("rabit mavlink --c", "--component,--csv")]
    [InlineData("rabit mavlink x.tlog --message GPS_R", "GPS_RAW_INT,GPS_RTCM_DATA,GPS_RTK")]
    [InlineData("rabit simulate --autopilot ", "ardupilot,px4")]
    [InlineData("rabit simulate --link tcp", "tcp:,tcpin:")]
    [InlineData("rabit completion ", "bash,fish,zsh")]
    [InlineData("rabit mavlink ", "")]
    [InlineData("rabit mavlink /", "")]
    [InlineData("rabit geolocate camera.json ", "")]
    public void Bash_ALineThatIsBegun_CompletesItsLastWord(string line, string expected)
    {
        string words = string.Join(" ", line.Split(' ').Select(w => $"'{w}'"));
        ToolProcess shell = ToolProcess.RunInShell(
            $$"""
            eval "$(rabit completion bash)"
            COMP_LINE='{{line}}' COMP_POINT={{line.Length}} COMP_WORDS=({{words}})
            COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
            _rabit
            [ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\n' "${COMPREPLY[@]}"
            """,
            "bash");

        Assert.Equal((0, 0), (shell.ExitCode, shell.Errors.Count));
        IEnumerable<string> found = shell.Output
            .Where(w => w is not ("top" or "graph" or "echo"))   // of running programs; not under Mono
            .OrderBy(w => w, StringComparer.Ordinal);
        Assert.Equal(expected, string.Join(",", found));
    }

    [Theory]
    [InlineData("bash", "complete -o bashdefault -o default -F _rabit rabit")]
    [InlineData("zsh", "compdef _rabit rabit")]
    [InlineData("fish", "complete -c rabit -a '(__rabit_complete)'")]
    public void Script_OfAShell_SaysWhereItGoesAndRegistersItself(string shell, string last)
    {
        ToolProcess tool = ToolProcess.Run("completion", shell);

        Assert.Equal((0, 0), (tool.ExitCode, tool.Errors.Count));
        Assert.Contains(tool.Output.Take(4), l => l.Contains("rabit completion " + shell));
        Assert.Equal(last, tool.Output[tool.Output.Count - 1]);
    }
}
