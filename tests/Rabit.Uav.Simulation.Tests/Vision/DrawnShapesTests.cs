using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>Panels whose class declares a shape, in drawn pictures with texture, blur, noise and JPEG.</summary>
public sealed class DrawnShapesTests(ITestOutputHelper output)
{
    private const double SideMetres = 1;

    // Of those of a shape, that are reported as another one.
    private const double MaxWrong = 0.06;

    private static readonly TargetShape[] Shapes =
        [TargetShape.Rectangle, TargetShape.Circle, TargetShape.Cross, TargetShape.Triangle];

    private static readonly (string Name, byte Red, byte Green, byte Blue)[] Colours =
        [("red", 205, 28, 32), ("blue", 28, 72, 205), ("yellow", 243, 214, 28), ("pink", 212, 36, 150)];

    // A class of each shape in each colour.
    private static readonly ImmutableArray<TargetClass> Classes =
    [
        .. Colours.SelectMany(c => Shapes.Select(s => new TargetClass($"{c.Name} {s}")
        {
            Colour = new ColourRange(c.Red, c.Green, c.Blue), Shape = s, MinSideMetres = 0.75, MaxSideMetres = 1.35,
            MaxAspect = 1.5,
        })),
    ];

    // The same in pairs of colours, side by side.
    private static readonly ImmutableArray<TargetClass> TwoColours =
    [
        .. Colours.SelectMany(c => Shapes.Select(s => new TargetClass($"{c.Name} {s}")
        {
            Colour = new ColourRange(c.Red, c.Green, c.Blue), SecondColour = SecondOf(c.Name), Shape = s,
            MinSideMetres = 0.75, MaxSideMetres = 1.35, MaxAspect = 1.5,
        })),
    ];

    private readonly TargetDetection[] _found = new TargetDetection[64];

    [Theory]
    [InlineData(12, 0.97)]
    [InlineData(24, 0.97)]
    public void Detect_AClassOfEachShape_FindsEachAsWhatItIs(double side, double minRecall)
        => Check(new ShapeTargetDetector(Classes), Classes, side, minRecall, maxRms: 0.2);

    [Theory, Trait("Category", "Long")]
    [InlineData(10, 0.9)]
    [InlineData(16, 0.97)]
    [InlineData(40, 0.97)]
    public void Detect_AClassOfEachShapeInOtherSizes_FindsEachAsWhatItIs(double side, double minRecall)
        => Check(new ShapeTargetDetector(Classes), Classes, side, minRecall, maxRms: 0.2);

    [Fact]
    public void Detect_TwoColoursAndAShape_FindsEachAsWhatItIs()
        => Check(new PanelTargetDetector(TwoColours), TwoColours, side: 24, minRecall: 0.85, maxRms: 0.5);

    [Fact, Trait("Category", "Long")]
    public void Detect_TwoColoursAndALargeShape_FindsEachAsWhatItIs()
        => Check(new PanelTargetDetector(TwoColours), TwoColours, side: 40, minRecall: 0.97, maxRms: 0.5);

    /// <summary>Squares, where a class of their colour declares another shape.</summary>
    [Theory]
    [InlineData(12, TargetShape.Circle, 4)]
    [InlineData(16, TargetShape.Cross, 4)]
    [InlineData(24, TargetShape.Triangle, 0)]
    public void Detect_SquaresWhereAnotherShapeIsDeclared_FindsHardlyAny(
        double side, TargetShape shape, int mostOf128)
        => CheckSquares(side, shape, mostOf128);

    [Theory, Trait("Category", "Long")]
    [InlineData(12, TargetShape.Triangle, 4)]
    [InlineData(24, TargetShape.Circle, 0)]
    [InlineData(24, TargetShape.Cross, 0)]
    public void Detect_SquaresOfOtherSizesWhereAnotherShapeIsDeclared_FindsHardlyAny(
        double side, TargetShape shape, int mostOf128)
        => CheckSquares(side, shape, mostOf128);

    private void CheckSquares(double side, TargetShape shape, int mostOf128)
    {
        const int seed = 7300;
        ImmutableArray<TargetClass> classes = [.. Classes.Where(c => c.Shape == shape)];
        var detector = new ShapeTargetDetector(classes);
        (int shown, int found) = (0, 0);
        for (int picture = 0; picture < 8; picture++)
        {
            shown += Draw(classes, seed + picture, side, out byte[] pixels, TargetShape.Rectangle).Count;
            found += Detect(detector, classes, pixels, side);
        }

        output.WriteLine($"seed {seed}: {found} of {shown} squares as {shape}");
        Assert.True(shown == 128 && found <= mostOf128, $"{found} of {shown} squares as {shape}");
    }

    private void Check(
        ITargetDetector detector, ImmutableArray<TargetClass> classes, double side, double minRecall, double maxRms)
    {
        const int seed = 7100;
        int[,] reported = new int[Shapes.Length, Shapes.Length + 1];
        (double squares, int right, int others) = (0, 0, 0);
        for (int picture = 0; picture < 24; picture++)
        {
            List<(DrawnForm Form, int Colour)> forms = Draw(classes, seed + picture, side, out byte[] pixels);
            int count = Detect(detector, classes, pixels, side);
            var formsOf = new int[count];
            foreach ((DrawnForm form, int colour) in forms)
            {
                int row = Array.IndexOf(Shapes, form.Shape);
                int here = 0;
                (int column, double error) = (Shapes.Length, 0);
                for (int i = 0; i < count; i++)
                {
                    double off = Math.Sqrt(Square(_found[i].CentreX - form.X) + Square(_found[i].CentreY - form.Y));
                    if (off > side / 2)
                        continue;
                    (formsOf[i], here) = (formsOf[i] + 1, here + 1);
                    string[] words = _found[i].Class.ToString().Split(' ');
                    Assert.Equal(Colours[colour].Name, words[0]);
                    (column, error) = (Array.FindIndex(Shapes, s => s.ToString() == words[1]), off);
                }

                reported[row, column]++;
                others += Math.Max(0, here - 1);
                (squares, right) = column == row ? (squares + (error * error), right + 1) : (squares, right);
            }

            others += formsOf.Count(f => f == 0);
        }

        double rms = Math.Sqrt(squares / right);
        output.WriteLine(FormattableString.Invariant($"seed {seed}, {side} px: RMS {rms:0.000} px, {others} others"));
        for (int row = 0; row < Shapes.Length; row++)
        {
            output.WriteLine($"{Shapes[row]} as "
                + string.Join(", ", Shapes.Select((s, i) => $"{s} {reported[row, i]}"))
                + $", missed {reported[row, Shapes.Length]}");
        }

        for (int row = 0; row < Shapes.Length; row++)
        {
            int all = Enumerable.Range(0, Shapes.Length + 1).Sum(i => reported[row, i]);
            Assert.True(reported[row, row] >= minRecall * all, $"{Shapes[row]}: {reported[row, row]} of {all}");
            int wrong = all - reported[row, row] - reported[row, Shapes.Length];
            Assert.True(wrong <= MaxWrong * all, $"{Shapes[row]}: {wrong} of {all} as another shape");
        }

        Assert.InRange(rms, 0, maxRms);
        Assert.Equal(0, others);
    }

    private static double Square(double value) => value * value;

    private static List<(DrawnForm Form, int Colour)> Draw(
        ImmutableArray<TargetClass> classes, int seed, double side, out byte[] pixels, TargetShape? only = null)
    {
        var random = new Random(seed);
        var scene = new DrawnScene(seed);
        var forms = new List<(DrawnForm, int)>();
        for (int i = 0; i < 16; i++)
        {
            var form = new DrawnForm(
                only ?? Shapes[(i + seed) % 4], 80 + (160 * (i % 4)) + (30 * random.NextDouble()),
                60 + (115 * (i / 4)) + (20 * random.NextDouble()), side * (0.9 + (0.2 * random.NextDouble())),
                2 * Math.PI * random.NextDouble(), 0.25 + (0.1 * random.NextDouble()));
            int colour = random.Next(Colours.Length);
            forms.Add((form, colour));
            (string name, byte red, byte green, byte blue) = Colours[colour];
            double light = 0.85 + (0.3 * random.NextDouble());
            scene.Draw(form.Contains, form.X, form.Y, form.Reach, DrawnScene.Linear(red, green, blue, light));
            if (classes == TwoColours)
            {
                ColourRange second = SecondOf(name);
                scene.Draw(
                    (x, y) => form.Contains(x, y) && form.IsInLeftHalf(x, y), form.X, form.Y, form.Reach,
                    DrawnScene.Linear(second.Red, second.Green, second.Blue, light));
            }
        }

        pixels = scene.Finish(0.5 + (0.45 * random.NextDouble()), 1, 85 + random.Next(9));
        return forms;
    }

    private static ColourRange SecondOf(string name) => name switch
    {
        "red" or "blue" => new ColourRange(236, 236, 232),
        _ => new ColourRange(22, 23, 25),
    };

    private int Detect(ITargetDetector detector, ImmutableArray<TargetClass> classes, byte[] pixels, double side)
        => detector.Detect(
            new DetectorInput(
                pixels, DrawnScene.Width, DrawnScene.Height, classes, PictureGroundScale.Uniform(SideMetres / side)),
            _found).Count;
}
