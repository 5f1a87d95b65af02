using System;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Terminal;
using Rabit.Uav.Messages;
using Spectre.Console;
using Xunit;
using Xunit.Abstractions;

namespace UavConsole.Tests;

/// <summary>The screen on terminals of several sizes, also one that is resized in flight.</summary>
public sealed class ScreenPainterTests(ITestOutputHelper output)
{
    private const string Keys = "r return  h hold";

    [Theory]
    [InlineData(40, 24)]
    [InlineData(80, 24)]
    [InlineData(200, 60)]
    public void Paint_AnySize_ShowsWhatAnOperatorNeeds(int columns, int rows)
    {
        string[] lines = Painted(columns, rows);

        Assert.Equal(rows, lines.Length);
        string all = string.Join("\n", lines);
        foreach (string expected in new[]
        {
            "searching", "lane 2 of 4", "next     lane 3 of 4", "Good", "62.0%", "1 of 4 flown", "87%",
            "GUIDED, armed", "111 m away at 234°", "5.0 m/s from 270°; 14 sats", "96 % usable", "3 confirmed",
            "1 red", "2 red", "3 red", "47.3974", "communications: ",
        })
            Assert.Contains(expected, all);
        Assert.Equal(Keys, lines[rows - 1]);
    }

    [Fact]
    public void Paint_WideEnough_ShowsTheMapWithScaleNorthAndNumbers()
    {
        foreach ((int columns, int rows) in new[] { (80, 24), (200, 60) })
        {
            string[] lines = Painted(columns, rows);

            Assert.Contains(lines, l => Regex.IsMatch(l, "├─*┤ [125]0* m"));
            Assert.Contains("▲", lines[1]);
            Assert.Contains("N", lines[2]);
            Assert.Contains(lines, l => Regex.IsMatch(l, "R[123]"));
        }
    }

    [Theory]
    [InlineData(80, 24, 2, "picture  2 found, sharp 0.34, 2 ms")]
    [InlineData(80, 24, 3, null)]   // the targets have its line
    [InlineData(200, 60, 3, "picture  2 detected, sharpness 0.34, 2 ms, 3 % clipped, ")]
    public void Paint_LastPicture_IsThereWhereTheTargetsLeaveRoom(int columns, int rows, int targets, string? expected)
    {
        string[] lines = Painted(columns, rows, targets);

        if (expected is null)
            Assert.DoesNotContain(lines, l => l.Contains("picture  "));
        else
            Assert.Contains(lines, l => l.Contains(expected));
    }

    [Fact]
    public void Paint_LargeScreen_HasMoreOfTheLogAndMoreTargets()
    {
        string[] small = Painted(80, 24, targets: 30);
        string[] large = Painted(200, 60, targets: 30);

        Assert.Equal(3, small.Count(IsOfTheLog));
        Assert.InRange(large.Count(IsOfTheLog), 8, 60);
        Assert.InRange(small.Count(l => l.Contains(" red 47.")), 3, 10);
        Assert.InRange(large.Count(l => l.Contains(" red      47.")), 20, 30);
        Assert.Contains(small, l => l.Contains("30 confirmed, 0 tentative"));
    }

    [Fact]
    public void Paint_BelowSixtyColumns_IsPlainLinesWithoutAMap()
    {
        string[] lines = Painted(59, 24);

        Assert.StartsWith("phase    searching", lines[1], StringComparison.Ordinal);
        Assert.DoesNotContain(lines, l => l.Contains('▲') || l.Any(c => c is >= '\u2800' and <= '\u28FF'));
    }

    [Fact]
    public void Paint_ResizedInFlight_IsAsOnANewTerminalOfThatSize()
    {
        LiveScreen screen = Screen();
        var terminal = new TerminalEmulator(100, 30);
        var painter = new ScreenPainter(terminal.Terminal());
        painter.Begin();
        foreach ((int columns, int rows) in new[]
        {
            (100, 30), (80, 24), (40, 24), (200, 60), (59, 12), (60, 16), (10, 3), (1, 1), (100, 30), (100, 24),
            (140, 24),
        })
        {
            terminal.Resize(columns, rows);
            painter.Paint((c, r) => screen.Draw(c, r));

            var fresh = new TerminalEmulator(columns, rows);
            new ScreenPainter(fresh.Terminal()).Paint((c, r) => screen.Draw(c, r));

            // The first line has the pace, by the clock.
            Assert.Equal(fresh.Lines.Skip(1), terminal.Lines.Skip(1));
        }
    }

    [Fact]
    public void Paint_WithoutColours_WritesNone()
    {
        var coloured = new TerminalEmulator(80, 24);
        var plain = new TerminalEmulator(80, 24);
        LiveScreen screen = Screen();
        new ScreenPainter(coloured.Terminal()).Paint((c, r) => screen.Draw(c, r));
        new ScreenPainter(plain.Terminal(ColorSystem.NoColors)).Paint((c, r) => screen.Draw(c, r));

        Assert.Matches("\u001b\\[[0-9;]*38;", coloured.Written);
        Assert.All(
            Regex.Matches(plain.Written, "\u001b\\[([0-9;]*)m").Cast<Match>().Select(m => m.Groups[1].Value),
            style => Assert.True(style is "" or "0" or "1"));
        Assert.Equal(coloured.Lines.Skip(1), plain.Lines.Skip(1));
    }

    [Fact]
    public void Paint_NothingChanged_WritesNothingUntilTheRepaint()
    {
        var terminal = new TerminalEmulator(20, 3);
        var painter = new ScreenPainter(terminal.Terminal());
        painter.Paint((_, _) => Words("one", "two"));
        int written = terminal.Written.Length;
        painter.Paint((_, _) => Words("one", "two"));
        Assert.Equal(written, terminal.Written.Length);

        terminal.Write("\u001b[2;1Hanother program");
        for (int picture = 0; picture < 60; picture++)
            painter.Paint((_, _) => Words("one", "two"));

        Assert.Equal(["one", "two", string.Empty], terminal.Lines);
    }

    [Fact]
    public void End_LeavesTheSecondPageWithTheLastPicture()
    {
        var terminal = new TerminalEmulator(20, 5);
        var painter = new ScreenPainter(terminal.Terminal());
        painter.Begin();
        painter.Paint((_, _) => Words("one", "two"));
        Assert.True(terminal.IsOnSecondPage);
        Assert.False(terminal.HasCursor);

        painter.End((_, _) => Words("the", "end"));

        Assert.False(terminal.IsOnSecondPage);
        Assert.True(terminal.HasCursor);
        Assert.EndsWith("the\nend\n", terminal.Written, StringComparison.Ordinal);
    }

    private string[] Painted(int columns, int rows, int targets = 3)
    {
        var terminal = new TerminalEmulator(columns, rows);
        LiveScreen screen = Screen(targets);
        new ScreenPainter(terminal.Terminal()).Paint((c, r) => screen.Draw(c, r));
        output.WriteLine(string.Join("\n", terminal.Lines));
        return terminal.Lines;
    }

    private static bool IsOfTheLog(string line) => Regex.IsMatch(line, "^ +[0-9]+[.][0-9]{6} ");

    private static LiveScreen Screen(int targets = 3)
        => new MissionScreen().Open(
            "searching: lane 2 of 4", DefaultTargetClasses.Red, keys: new FixedHints(Keys), targets: targets);

    private static Rows Words(params string[] lines) => new Rows(lines.Select(l => new Markup(l)));
}
