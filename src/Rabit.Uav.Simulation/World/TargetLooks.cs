using System;
using System.Globalization;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The looks of all kinds of targets. Those of one world wear the same jackets and drive the same cars.
/// </summary>
internal static class TargetLooks
{
    private const ulong PurposeOfChoice = 0x636C6F74686573;
    private const double MarkerSideMetres = 1.6;

    private static readonly SurfaceColour White = new(232, 232, 228);
    private static readonly SurfaceColour Black = new(24, 25, 27);
    private static readonly SurfaceColour Red = new(205, 28, 32);
    private static readonly SurfaceColour Blue = new(28, 72, 205);
    private static readonly SurfaceColour Yellow = new(243, 214, 28);
    private static readonly SurfaceColour Skin = new(198, 150, 122);
    private static readonly SurfaceColour Trousers = new(46, 50, 62);
    private static readonly SurfaceColour Glass = new(30, 36, 42);
    private static readonly SurfaceColour Lamp = new(200, 204, 206);

    private static readonly SurfaceColour[] Jackets = [Red, new(242, 112, 18), Blue, Yellow];
    private static readonly SurfaceColour[] Paints = [White, Red, Blue, new(168, 172, 176)];

    // Cells of 10 cm by 10 cm: head, jacket with the arms, trousers.
    private static readonly string[] PersonCells =
    [
        "...22..", "..2222.", "..2222.", ".000000", "0000000", "0.000.0", "0.000.0", "0.000.0", "2.000.2", "..111..",
        "..111..", ".11111.", ".11.11.", ".11.11.", ".11.11.", ".11.11.", ".11.11.", ".33.33.",
    ];

    // Cells of 20 cm by 20 cm, the front first.
    private static readonly string[] CarCells =
    [
        ".2000002.", "000000000", "000000000", "000000000", "000000000", "000000000", "011111110", "011111110",
        "001111100", "010000010", "010000010", "010000010", "010000010", "010000010", "010000010", "010000010",
        "001111100", "011111110", "000000000", "000000000", "000000000", ".3000003.",
    ];

    /// <summary>What a target looks like; not of <see cref="SimulatedTargetKind.ColouredPanel"/>.</summary>
    /// <param name="kind">Which kind.</param>
    /// <param name="number">How many of its kind came before it in the world.</param>
    /// <param name="seed">Of the world.</param>
    public static TargetLook Of(SimulatedTargetKind kind, int number, ulong seed)
    {
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfChoice, (ulong)kind));
        int first = random.Next(1000);
        int choice = first + number;
        return kind switch
        {
            SimulatedTargetKind.WhitePanel => Panel("white", White),
            SimulatedTargetKind.BlackPanel => Panel("black", Black),
            SimulatedTargetKind.TwoColouredPanel => (choice % 3) switch
            {
                0 => Panel("red-white", Red, White, "0", "1"),
                1 => Panel("blue-yellow", Blue, Yellow, "0", "1"),
                _ => Panel("black-white", Black, White, "01", "10"),
            },
            SimulatedTargetKind.Person => Person(Jackets[first % Jackets.Length]),
            SimulatedTargetKind.Car => Car(Paints[first % Paints.Length]),
            SimulatedTargetKind.ArUcoMarker => Marker("aruco", MarkerFamily.ArUco4x4, choice),
            SimulatedTargetKind.AprilTagMarker => Marker("apriltag", MarkerFamily.AprilTag36h11, choice),
            _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "There is no such kind of target."),
        };
    }

    private static TargetLook Panel(string name, SurfaceColour colour)
        => new(name + " panel", new TargetClass(name) { Colour = RangeOf(colour) }, 1, 1, SurfacePattern.Of(colour));

    private static TargetLook Panel(string name, SurfaceColour one, SurfaceColour other, params string[] cells)
        => new(
            name + " panel", new TargetClass(name) { Colour = RangeOf(one), SecondColour = RangeOf(other) }, 1, 1,
            SurfacePattern.Of([one, other], cells));

    private static TargetLook Person(SurfaceColour jacket) => new(
        "person",
        new TargetClass("person")
        {
            Colour = RangeOf(jacket),
            MinSideMetres = 0.5,
            MaxSideMetres = 1.3,
            MinAspect = 1.3,
            MaxAspect = 4.5,
            MinColourShare = 0.35,
        },
        sideMetres: 1.75, widthMetres: 0.65, SurfacePattern.Of([jacket, Trousers, Skin, Black], PersonCells));

    private static TargetLook Car(SurfaceColour paint) => new(
        "car",
        new TargetClass("car")
        {
            Colour = RangeOf(paint),
            MinSideMetres = 2.3,
            MaxSideMetres = 3.6,
            MinAspect = 1.7,
            MaxAspect = 3.2,
            MinColourShare = 0.65,
        },
        sideMetres: 4.4, widthMetres: 1.8, SurfacePattern.Of([paint, Glass, Lamp, Red], CarCells));

    // The white border is one cell wide.
    private static TargetLook Marker(string name, MarkerFamily family, int choice)
    {
        int id = choice % MarkerPattern.Count(family);
        int cells = MarkerPattern.CellsPerSide(family);
        int side = cells + 2;
        byte[] pattern = new byte[side * side];
        for (int i = 0; i < pattern.Length; i++)
            pattern[i] = (byte)(MarkerPattern.IsWhite(family, id, (i / side) - 1, (i % side) - 1) ? 0 : 1);
        double paper = MarkerSideMetres * side / cells;
        return new TargetLook(
            name + " " + id.ToString(CultureInfo.InvariantCulture) + ", marker",
            new TargetClass(name)
            {
                Marker = new TargetMarker(family),
                MinSideMetres = 0.75 * MarkerSideMetres,
                MaxSideMetres = 1.3 * MarkerSideMetres,
            },
            paper, paper, new SurfacePattern(side, side, pattern, [White, Black]))
        { MarkerId = id };
    }

    private static ColourRange RangeOf(SurfaceColour colour)
        => new((byte)colour.Red, (byte)colour.Green, (byte)colour.Blue);
}
