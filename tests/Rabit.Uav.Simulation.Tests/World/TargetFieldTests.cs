using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation.Tests.Camera;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.World;

public class TargetFieldTests(ITestOutputHelper output)
{
    private static readonly NedPosition[] Rectangle = Scene.Corners((30, -80), (150, -80), (150, 80), (30, 80));

    // A U, open to the north, and turned the other way round.
    private static readonly NedPosition[] Horseshoe =
        Scene.Corners((0, 0), (100, 0), (100, 30), (30, 30), (30, 70), (100, 70), (100, 100), (0, 100));

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Place_ManySeeds_KeepsAllDistances(bool isHorseshoe)
    {
        NedPosition[] area = isHorseshoe ? Horseshoe : Rectangle;
        for (ulong seed = 0; seed < 300; seed++)
        {
            IReadOnlyList<SimulatedTarget> things = TargetField.Place(seed, area, targets: 5, distractors: 6);

            string which = $"seed {seed}";
            Assert.Equal(Enumerable.Range(1, 11), things.Select(t => t.Id));
            Assert.True(things.All(t => IsWellInside(area, t)), which);
            for (int i = 0; i < things.Count; i++)
                Assert.True(things.Take(i).All(t => Distance(t, things[i]) >= 12), which);
        }
    }

    [Fact]
    public void Place_ManySeeds_FillsTheWholeArea()
    {
        int[] quarters = new int[4];
        for (ulong seed = 0; seed < 300; seed++)
        {
            foreach (SimulatedTarget thing in TargetField.Place(seed, Rectangle, targets: 5, distractors: 0))
                quarters[(thing.Position.North > 90 ? 2 : 0) + (thing.Position.East > 0 ? 1 : 0)]++;
        }

        output.WriteLine(string.Join(" ", quarters));
        Assert.All(quarters, q => Assert.InRange(q, 300, 450));
    }

    [Fact]
    public void Place_SameSeed_GivesTheSame()
    {
        string first = Text(TargetField.Place(42, Rectangle, 5, 6));

        Assert.Equal(first, Text(TargetField.Place(42, Rectangle, 5, 6)));
        Assert.NotEqual(first, Text(TargetField.Place(43, Rectangle, 5, 6)));
    }

    [Fact]
    public void Place_SeedOne_IsThePlaceItAlwaysWas()
    {
        // A flight that is known by its seed is to find the same world in years to come, on every runtime.
        SimulatedTarget first = TargetField.Place(1, Rectangle, 5, 6)[0];

        Assert.Equal(
            "red panel 1 94.380571 -33.440573 5.039165",
            $"{first.Name} {first.Position.North:F6} {first.Position.East:F6} {first.Heading.Radians:F6}");
    }

    [Fact]
    public void Place_Targets_AreSquaresOfOneMetreInNominalColours()
    {
        for (ulong seed = 0; seed < 100; seed++)
        {
            SimulatedTarget[] targets = TargetField.Place(seed, Rectangle, 5, 10).Where(t => !t.IsDistractor).ToArray();

            Assert.Equal(5, targets.Length);
            Assert.Equal(5, targets.Select(t => t.Class).Distinct().Count());
            foreach (SimulatedTarget target in targets)
            {
                Assert.Equal((1.0, 1.0), (target.SideMetres, target.WidthMetres));
                (int red, int green, int blue) = Nominal(target.Class);
                Assert.True(
                    IsWithinTenth(target.Surface.Red, red) && IsWithinTenth(target.Surface.Green, green)
                        && IsWithinTenth(target.Surface.Blue, blue),
                    $"seed {seed}, {target.Name}");
            }
        }
    }

    [Fact]
    public void Place_Distractors_HaveTheWrongColourOrTheWrongSize()
    {
        foreach (SimulatedTarget thing in TargetField.Place(7, Rectangle, 0, 20))
        {
            bool isRightSize = thing.SideMetres is > 0.5 and < 1.5 && thing.WidthMetres is > 0.5 and < 1.5;
            Assert.True(thing.IsDistractor);
            Assert.True(thing.Class == TargetClassName.None ? isRightSize : !isRightSize, thing.Name);
        }
    }

    [Fact]
    public void Place_RoomForTheTargetsOnly_LeavesDistractorsOut()
    {
        NedPosition[] tiny = Scene.Corners((0, 0), (0, 11), (11, 11), (11, 0));

        Assert.False(Assert.Single(TargetField.Place(1, tiny, targets: 1, distractors: 6)).IsDistractor);
    }

    [Fact]
    public void Place_NoRoom_SaysSo()
    {
        NedPosition[] small = Scene.Corners((0, 0), (0, 30), (30, 30), (30, 0));

        ArgumentException fault = Assert.Throws<ArgumentException>(
            () => TargetField.Place(1, small, targets: 20, distractors: 3));

        Assert.Contains("20 targets do not fit into the area", fault.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(
            () => TargetField.Place(1, Scene.Corners((0, 0), (0, 7), (7, 7), (7, 0)), targets: 1, distractors: 0));
        Assert.Throws<ArgumentException>(
            () => TargetField.Place(1, Scene.Corners((0, 0), (50, 50), (100, 100)), targets: 1, distractors: 0));
    }

    [Fact]
    public void Place_NoArea_SaysWhy()
    {
        Assert.Contains(
            "3 corners",
            Assert.Throws<ArgumentException>(() => TargetField.Place(1, Scene.Corners((0, 0), (1, 1)), 1, 0)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "Corner 2",
            Assert.Throws<ArgumentException>(
                () => TargetField.Place(1, Scene.Corners((0, 0), (1, double.NaN), (5, 5)), 1, 0)).Message,
            StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => TargetField.Place(1, null!, 1, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => TargetField.Place(1, Rectangle, -1, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => TargetField.Place(1, Rectangle, 0, -1));
    }

    [Fact]
    public void Place_Nothing_IsEmpty() => Assert.Empty(TargetField.Place(1, Rectangle, 0, 0));

    // Another way than the product's: the area as a sum of angles, and the distance to many points of the edge.
    private static bool IsWellInside(NedPosition[] area, SimulatedTarget thing)
    {
        double turn = 0;
        double nearest = double.MaxValue;
        for (int i = 0; i < area.Length; i++)
        {
            (double n1, double e1) = (area[i].North - thing.Position.North, area[i].East - thing.Position.East);
            (double n2, double e2) = (area[(i + 1) % area.Length].North - thing.Position.North,
                area[(i + 1) % area.Length].East - thing.Position.East);
            turn += Math.Atan2((n1 * e2) - (n2 * e1), (n1 * n2) + (e1 * e2));
            for (int step = 0; step <= 1000; step++)
            {
                (double n, double e) = (n1 + ((n2 - n1) * step / 1000), e1 + ((e2 - e1) * step / 1000));
                nearest = Math.Min(nearest, Math.Sqrt((n * n) + (e * e)));
            }
        }

        return Math.Abs(turn) > 6 && nearest >= 4;
    }

    private static double Distance(SimulatedTarget a, SimulatedTarget b)
        => Math.Sqrt(Math.Pow(a.Position.North - b.Position.North, 2) + Math.Pow(a.Position.East - b.Position.East, 2));

    private static bool IsWithinTenth(int value, int nominal) => Math.Abs(value - nominal) <= (0.1 * nominal) + 0.5;

    private static (int Red, int Green, int Blue) Nominal(TargetClassName colour) => colour.ToString() switch
    {
        "red" => (205, 28, 32),
        "orange" => (242, 112, 18),
        "blue" => (28, 72, 205),
        "yellow" => (243, 214, 28),
        "magenta" => (212, 36, 150),
        _ => throw new ArgumentOutOfRangeException(nameof(colour), colour, "A target has one of the five colours."),
    };

    private static string Text(IEnumerable<SimulatedTarget> things) => string.Join(
        "; ",
        things.Select(t => $"{t.Name} {t.Position.North:R} {t.Position.East:R} {t.Heading.Radians:R} {t.Surface.Red} "
            + $"{t.Surface.Green} {t.Surface.Blue}"));
}
