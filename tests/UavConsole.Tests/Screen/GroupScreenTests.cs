using System;
using System.Linq;
using Xunit;

namespace UavConsole.Tests.Screen;

/// <summary>The screen of a group, without a terminal.</summary>
public sealed class GroupScreenTests : IDisposable
{
    private const int Width = 110;

    private readonly GroupFlight _flight = GroupFlight.Open(CommandLineRun.Read("--vehicles", "3", "--headless"), null);

    [Fact]
    public void Draw_BeforeTheStart_HasALineForEachVehicle()
    {
        string[] lines = Draw(rows: 40);
        Assert.Equal(3, lines.Count(l => l.Contains("not switched on yet", StringComparison.Ordinal)));
    }

    [Fact]
    public void Draw_Flying_ShowsTheMapWithAllVehiclesAndWhatEachDoes()
    {
        Fly();
        string[] lines = Draw(rows: 40);

        int head = Array.FindIndex(lines, l => l.StartsWith("vehicle ", StringComparison.Ordinal));
        // Without the title above it, and the scale below.
        string map = string.Join("\n", lines.Skip(1).Take(head - 2));
        Assert.All(Enumerable.Range(1, 3), n => Assert.Contains(FormattableString.Invariant($"{n}"), map));
        for (int i = 0; i < 3; i++)
        {
            Assert.StartsWith(FormattableString.Invariant($"{i + 1}  "), lines[head + 1 + i]);
            Assert.Contains("taking off", lines[head + 1 + i], StringComparison.OrdinalIgnoreCase);
        }
    }

    [Theory]
    [InlineData(40)]
    [InlineData(12)]
    [InlineData(5)]
    public void Draw_AnyHeight_FitsIntoTheTerminal(int rows)
    {
        Fly();
        string[] lines = Draw(rows);
        Assert.InRange(lines.Length, 4, rows);
        Assert.All(lines, l => Assert.InRange(l.Length, 0, Width));
        Assert.DoesNotContain(string.Concat(lines), c => c > 0x7e || c < ' ');
        Assert.Contains(lines, l => l.StartsWith("3  ", StringComparison.Ordinal));
    }

    public void Dispose()
    {
        _flight.Group.Finish();
        _flight.Dispose();
    }

    // Until all have taken off.
    private void Fly()
    {
        while (_flight.Group.Now < TimeSpan.FromSeconds(15))
            _flight.Group.Step();
        foreach (GroupVehicle vehicle in _flight.Vehicles)
            vehicle.Refresh();
    }

    private string[] Draw(int rows)
        => PlainConsole.Draw(new GroupScreen(_flight).Draw(Width, rows, isUnicode: false), Width, rows).TrimEnd()
            .Split('\n').Select(l => l.TrimEnd('\r', ' ')).ToArray();
}
