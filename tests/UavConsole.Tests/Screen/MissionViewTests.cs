using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Reporting.Tests;
using Spectre.Console;
using Xunit;
using Xunit.Abstractions;

namespace UavConsole.Tests;

/// <summary>The screen of a mission on a terminal of 80 by 24, without a terminal.</summary>
public sealed class MissionViewTests(ITestOutputHelper output)
{
    [Fact]
    public void Draw_InTheMiddleOfASearch_FitsAndShowsAll()
    {
        string[] lines = Draw("lane 2 of 4", DefaultTargetClasses.Red).Split('\n')
            .Select(l => l.TrimEnd('\r', ' ')).ToArray();

        Assert.InRange(lines.Count(l => l.Length > 0), 20, 24);
        Assert.All(lines, l => Assert.InRange(l.Length, 0, 80));
        string all = string.Join("\n", lines);
        foreach (string expected in new[]
        {
            "search of a meadow", "searching", "lane 2 of 4", "62.0%", "1 of 4 flown", "1 confirmed",
            "1 red 47.39740 8.54505 ±2.4", "next     lane 3 of 4",
            "GUIDED, armed", "87%", "Good", "H", "R", "sensor fusion", "Ended, 3 runs"
        })
            Assert.Contains(expected, all);
    }

    [Fact]
    public void Draw_HostileTexts_ShowsThemAsTheyAre()
    {
        string drawn = Draw(
            "[red]a[/] [[b\u001b[2J\nc \u0007 and so on, far longer than there is room", DefaultTargetClasses.Red);

        Assert.Contains("[red]a[/] [[b.[2J.c", drawn);
        Assert.DoesNotContain(drawn, c => char.IsControl(c) && c != '\n' && c != '\r');
        Assert.All(drawn.Split('\n'), l => Assert.InRange(l.TrimEnd('\r').Length, 0, 80));
    }

    // Shown before --fly arms: what refuses the flight is never below the edge of the screen.
    [Fact]
    public void Draw_BeforeTheMotorsRun_ShowsTheChecklistWithItsFailuresFirst()
    {
        string drawn = Draw(
            "waiting", DefaultTargetClasses.Red, MissionPhase.WaitingForVehicle, isArmed: false,
            Checklist(passing: 30));
        string[] lines = drawn.Split('\n').Select(l => l.TrimEnd('\r', ' ')).ToArray();

        Assert.InRange(lines.Count(l => l.Length > 0), 20, 24);
        Assert.All(lines, l => Assert.InRange(l.Length, 0, 80));
        Assert.Contains("pre-flight checklist: REFUSES THE FLIGHT", lines[1]);
        Assert.Contains("fail     battery: 31 %", lines[2]);
        Assert.Contains("override hdop: 2.1", lines[3]);
        Assert.Contains("warn     return-height: 15 m; set", lines[4]);
        Assert.Contains("more lines", drawn);
    }

    [Fact]
    public void Draw_MotorsRun_ShowsTheMapAgain()
        => Assert.DoesNotContain(
            "pre-flight", Draw("climbing", DefaultTargetClasses.Red, MissionPhase.Arming, true, Checklist(passing: 1)));

    [Fact]
    public void Draw_TakenOver_SaysHowToCommandAgain()
    {
        string drawn = Draw("the pilot took over", DefaultTargetClasses.Red, MissionPhase.HandedOver);

        Assert.Contains("nothing is commanded. To command again", drawn);
        Assert.Contains("--return or --resume FILE", drawn);
        Assert.All(drawn.Split('\n'), l => Assert.InRange(l.TrimEnd('\r').Length, 0, 80));
    }

    [Fact]
    public void Draw_WithKeys_ShowsThemInTheLastLineAndStillFits()
    {
        string[] lines = Draw("lane 2 of 4", DefaultTargetClasses.Red, keys: new FixedHints("r return  h hold [x]"))
            .Split('\n').Select(l => l.TrimEnd('\r', ' ')).Where(l => l.Length > 0).ToArray();

        Assert.InRange(lines.Length, 20, 24);
        Assert.Equal("r return  h hold [x]", lines.Last());
    }

    private static PreflightReport Checklist(int passing) => new()
    {
        IsComplete = true,
        Lines =
        [
            .. Enumerable.Range(0, passing).Select(
                i => new PreflightLine($"line {i}", PreflightResult.Pass, "good", string.Empty, IsOverridden: false)),
            new("return-height", PreflightResult.Warn, "15 m", "set obstacleHeightMetres", IsOverridden: false),
            new("hdop", PreflightResult.Fail, "2.1", string.Empty, IsOverridden: true),
            new("battery", PreflightResult.Fail, "31 %", "charge it", IsOverridden: false),
        ],
    };

    private string Draw(
        string missionText, TargetClassName colour, MissionPhase phase = MissionPhase.Searching, bool isArmed = true,
        PreflightReport? checklist = null, IKeyHints? keys = null)
    {
        string drawn = Draw(new MissionScreen().Open(missionText, colour, phase, isArmed, checklist, keys));
        output.WriteLine(drawn);
        return drawn;
    }

    private static string Draw(LiveScreen screen)
    {
        var text = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(text),
        });
        console.Profile.Width = 80;
        console.Profile.Height = 24;
        console.Write(screen.Draw());
        return text.ToString();
    }
}
