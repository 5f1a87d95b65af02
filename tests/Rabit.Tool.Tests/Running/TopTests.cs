using System;
using System.Linq;
using Rabit.Diagnostics.Protocol;
using Rabit.Tool.Running.Top;
using Xunit;

namespace Rabit.Tool.Tests.Running;

/// <summary>The table of rabit top: its order, its filter, its keys, and what has room.</summary>
public sealed class TopTests
{
    [Fact]
    public void Select_EachOrder_SortsTheRows()
    {
        TopTable managers = Managers(new TopTables(), Sample());
        Assert.Equal(["b", "a", "c"], Names(new TopSettings()));
        Assert.Equal(["a", "b", "c"], Names(new TopSettings { Order = TopOrder.Name }));
        Assert.Equal(["c", "b", "a"], Names(new TopSettings { Order = TopOrder.Rate }));
        Assert.Equal(["a", "c", "b"], Names(new TopSettings { Order = TopOrder.Load }));
        Assert.Equal(["a", "c", "b"], Names(new TopSettings { Order = TopOrder.Trouble }));
        Assert.Equal(["b", "c", "a"], Names(new TopSettings { Order = TopOrder.Load, IsReversed = true }));
        Assert.Equal(["b"], Names(new TopSettings { Filter = "B" }));

        string[] Names(TopSettings settings) => managers.Select(settings).Select(r => r.Name).ToArray();
    }

    [Fact]
    public void Make_TheSecondSample_HasRatesOfTheCauses()
    {
        var tables = new TopTables();
        Assert.Equal("timer post", Cell(Managers(tables, Sample()), "b", "woken by, 1/s"));

        TopTable second = Managers(tables, Sample(timer: 18, post: 7));

        Assert.Equal("timer 8.00 post 2.00", Cell(second, "b", "woken by, 1/s"));
    }

    [Fact]
    public void Make_HostileNames_AreOneLineWithoutControls()
    {
        SampleLine sample = Sample() with
        {
            Reactors = [new ReactorFigures
            {
                Queues = [new QueueFigures { Name = "\u001b[2J" + new string('x', 100), Capacity = 3, Level = 3 }],
            }],
        };

        TopRow row = new TopTables().Make(sample)[1].Rows[0];

        Assert.Equal(".[2J" + new string('x', 34) + "..", row.Cells[0].Text);
        Assert.True(row.Cells[2].IsWarning);
    }

    [Fact]
    public void Fit_NarrowTerminals_LeavesOutColumnsAndThenCutsTheName()
    {
        TopTable managers = Managers(new TopTables(), Sample());
        Assert.Equal(managers.Columns.Count, TopFit.Fit(managers, 400).Count);
        foreach (int width in Enumerable.Range(30, 170))
            Assert.InRange(TopFit.Fit(managers, width).Sum(c => c.Width + TopFit.Gap) - TopFit.Gap, 1, width);
        Assert.Equal(0, Assert.Single(TopFit.Fit(managers, 5)).Column);
    }

    [Fact]
    public void Press_Keys_ChangeWhatIsShown()
    {
        var settings = new TopSettings();
        var keys = new TopKeys(settings);
        Press("2tv/pO\b\r");
        Assert.Equal(
            (TopSection.Queues, TopOrder.Trouble, true, "p", false),
            (settings.Section, settings.Order, settings.IsReversed, settings.Filter, settings.IsTyping));

        Press("/q");
        Assert.Equal("pq", settings.Filter);
        Press("\u001b");
        Assert.Equal((string.Empty, false), (settings.Filter, settings.IsTyping));
        keys.Press(new ConsoleKeyInfo('\0', ConsoleKey.DownArrow, false, false, false));
        Assert.Equal(1, settings.Scroll);
        keys.Press(new ConsoleKeyInfo('\0', ConsoleKey.PageUp, false, false, false));
        Assert.Equal(0, settings.Scroll);
        Assert.False(keys.Press(new ConsoleKeyInfo('q', ConsoleKey.Q, false, false, false)));

        void Press(string text)
        {
            foreach (char c in text)
                Assert.True(keys.Press(new ConsoleKeyInfo(c, KeyOf(c), false, false, false)));
        }
    }

    private static ConsoleKey KeyOf(char c) => c switch
    {
        '\r' => ConsoleKey.Enter,
        '\b' => ConsoleKey.Backspace,
        '\u001b' => ConsoleKey.Escape,
        _ => ConsoleKey.NoName,
    };

    private static TopTable Managers(TopTables tables, SampleLine sample) => tables.Make(sample)[0];

    private static string Cell(TopTable table, string row, string column)
        => table.Rows.Single(r => r.Name == row)
            .Cells[table.Columns.ToList().FindIndex(c => c.Head == column)].Text;

    private static SampleLine Sample(long timer = 10, long post = 5) => new()
    {
        Reactors =
        [
            new ReactorFigures
            {
                Managers =
                [
                    new ManagerFigures
                    {
                        Name = "b", RunsPerSecond = 10, Load = 0.1,
                        WakeUps = new WakeUpFigures { Timer = timer, Post = post },
                    },
                    new ManagerFigures { Name = "a", RunsPerSecond = 1, Load = 0.5, Faults = 1 },
                    new ManagerFigures { Name = "c", RunsPerSecond = 100, Load = 0.2, MissedDeadlines = 3 },
                ],
            },
        ],
    };
}
