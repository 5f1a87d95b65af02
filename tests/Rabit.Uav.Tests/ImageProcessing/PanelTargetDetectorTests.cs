using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Panels of two colours, of black and of white, in painted pictures: 1 m, 13 pixels and others.</summary>
public sealed class PanelTargetDetectorTests(ITestOutputHelper output)
{
    private const double MetresPerPixel = 1.0 / 13;

    private static readonly (double, double, double) Black = (22, 23, 25);
    private static readonly (double, double, double) White = (236, 236, 232);
    private static readonly (double, double, double) Red = (205, 28, 32);
    private static readonly (double, double, double) Blue = (28, 72, 205);
    private static readonly (double, double, double) Yellow = (243, 214, 28);

    private static readonly ImmutableArray<TargetClass> Classes =
    [
        ClassOf("chequered", Black, White),
        ClassOf("signal", Red, White),
        ClassOf("flag", Blue, Yellow),
        ClassOf("warning", Yellow, Black),
        ClassOf("white", White),
        ClassOf("black", Black),
    ];

    private readonly PanelTargetDetector _detector = new(Classes);
    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Theory]
    [InlineData(8, 1, 0.7)]   // those that stand on a corner are missed in part
    [InlineData(10, 1, 0.97)]
    [InlineData(13, 1, 0.99)]
    [InlineData(13, 0.55, 0.99)]   // in the shade
    [InlineData(24, 1, 0.99)]
    public void Detect_PanelsAnyhow_FindsThemWithATrueCovarianceAndTheirBearing(
        double side, double light, double minRecall)
    {
        const int seed = 700;
        var random = new Random(seed + (int)side);
        var score = new Score();
        int kinds = side < 10 ? 4 : 6;   // of one colour they must be larger
        for (int picture = 0; picture < 8; picture++)
        {
            var painting = new Painting(seed + picture);
            var truth = Enumerable.Range(0, kinds).Select(i => (
                Class: Classes[i], X: 60 + (100 * i) + (20 * random.NextDouble()), Y: 60 + (350 * random.NextDouble()),
                Angle: Math.PI / 2 * random.NextDouble(), IsChequered: random.Next(2) == 0)).ToArray();
            foreach (var one in truth)
                Paint(painting, one.Class, one.X, one.Y, side, one.Angle, one.IsChequered);
            DetectorInput input = Input(Shade(painting.Finish(), light), 1 / side);
            int count = _detector.Detect(input, _found).Count;
            Assert.All(_found.Take(count), f => Assert.Null(DetectionCheck.FindFault(f, input)));
            foreach (var one in truth)
                score.Add(_found.AsSpan(0, count), one.Class, one.X, one.Y, one.Angle);
            score.Close(count);
        }

        output.WriteLine($"seed {seed}, {side} px, light {light}: {score}");
        Assert.True(score.Found >= minRecall * score.Of && score.False == 0, $"seed {seed}: {score}");
        Assert.InRange(score.MeanSquare, 0.3, 2.8);
        Assert.True(score.Inside >= 0.92, $"seed {seed}: {score}");
        Assert.True(side < 12 || score.MaxTurnDegrees < 8, $"seed {seed}: {score}");
    }

    [Fact]
    public void Detect_OtherThings_FindsNone()
    {
        var painting = new Painting(2);
        painting.Rectangle(Black, 80, 80, 60, 9, 0.3);              // a ditch
        painting.Rectangle(White, 200, 100, 200, 6, 0.1);           // a line
        painting.TwoColours(Black, White, 330, 90, 40, 0.4, true);  // too large
        painting.TwoColours(Black, White, 450, 90, 4, 0.4, true);   // too small
        painting.Rectangle(Red, 80, 300, 13, 13, 0.2);              // of one of two colours
        painting.Rectangle((60, 70, 45), 200, 300, 13, 13, 0.2);    // a shadow
        painting.Rectangle((140, 140, 135), 320, 300, 13, 13, 0.2); // concrete
        painting.TwoColours(Black, White, 639, 400, 13, 0, true);   // cut by the border
        Assert.Equal(DetectorResult.Found(0), _detector.Detect(Input(painting.Finish()), _found));
    }

    /// <summary>
    /// A JPEG keeps colours at half the resolution: ground beside a panel is as bright as before, and of its hue.
    /// </summary>
    [Fact]
    public void Detect_ColourThatAJpegSpreadsOverTheGround_IsNotOfThePanel()
    {
        var painting = new Painting(8);
        painting.Rectangle((128, 116, 40), 209, 159, 5, 5, 0);
        painting.Rectangle((128, 116, 40), 191, 159, 5, 5, 0);
        painting.TwoColours(Blue, Yellow, 200, 150, 15, 0, isChequered: false);

        Assert.Equal(DetectorResult.Found(1), _detector.Detect(Input(painting.Finish()), _found));
        Assert.Equal("flag", _found[0].Class.ToString());
        Assert.InRange(_found[0].SideMetres, 1.05, 1.25);
        Assert.Equal(200, _found[0].CentreX, 0.3);
        Assert.Equal(150, _found[0].CentreY, 0.3);
    }

    /// <summary>
    /// Lush grass has more than half of the chroma that a panel has in the shade: twice the ground's is out of reach.
    /// </summary>
    [Theory]
    [InlineData(1)]
    [InlineData(0.6)]
    public void Detect_GroundWithMuchColourOfItsOwn_HidesNoPanel(double light)
    {
        var painting = new Painting(9);
        painting.Rectangle((50, 130, 36), 320, 240, Painting.Width, Painting.Height, 0);
        painting.TwoColours(
            (28 * light, 72 * light, 205 * light), (243 * light, 214 * light, 28 * light), 200, 150, 15, 0.3, false);

        Assert.Equal(DetectorResult.Found(1), _detector.Detect(Input(painting.Finish()), _found));
        Assert.Equal("flag", _found[0].Class.ToString());
    }

    [Fact]
    public void Detect_FromAslant_MeasuresItOnTheGround()
    {
        var camera = new CameraModel
        {
            Width = Painting.Width,
            Height = Painting.Height,
            FocalX = 530,
            FocalY = 530,
            CentreX = 320,
            CentreY = 240,
        };
        var painting = new Painting(5);

        // From 45 degrees: the sides along the view are shorter by that much.
        for (int row = 0; row < 2; row++)
            painting.Rectangle(row == 0 ? Black : White, 320, 240 + (5 * (row - 0.5)), 14, 5, 0);
        double range = 530 / 14.0;
        Rotation nedFromCamera = Rotation.FromEuler(EulerAngles.FromRadians(0, -Math.PI / 4, 0))
            * Rotation.FromMatrix(0, 0, 1, 1, 0, 0, 0, 1, 0);
        var input = new DetectorInput(
            painting.Finish(), Painting.Width, Painting.Height, Classes,
            PictureGroundScale.OfLevelGround(camera, nedFromCamera, range * Math.Sqrt(0.5)));

        Assert.Equal(DetectorResult.Found(1), _detector.Detect(input, _found));
        Assert.Equal("chequered", _found[0].Class.ToString());
        Assert.InRange(_found[0].SideMetres, 0.9, 1.1);
    }

    [Fact]
    public void FindFaults_ColoursThatAreNone_NamesThem()
    {
        TargetClass With(ColourRange? colour, ColourRange? second)
            => new("panel") { Colour = colour, SecondColour = second };
        string FaultOf(TargetClass one) => Assert.Single(TargetClass.FindFaults([one]));
        var red = new ColourRange(205, 28, 32);
        var grey = new ColourRange(128, 128, 128);
        var white = new ColourRange(240, 240, 240);
        Assert.Contains("the colours of target class panel: they are the same", FaultOf(With(red, red)));
        Assert.Contains("too near to each other", FaultOf(With(white, new ColourRange(220, 220, 220))));
        Assert.Contains("one of them is grey", FaultOf(With(red, grey)));
        Assert.Contains("it has a SecondColour, and no Colour", FaultOf(With(null, red)));
        Assert.Contains(
            "has no panel, which the panel detector needs",
            Assert.Throws<ArgumentException>(() => new PanelTargetDetector([With(red, null)])).Message);
        Assert.True(With(white, null).IsPanel && With(red, white).IsPanel);
        Assert.False(With(red, null).IsPanel || With(grey, null).IsPanel);
    }

    [Fact]
    public void Detect_ThermalPicture_IsNotSearched()
    {
        var input = new DetectorInput(
            new byte[200], 10, 10, Classes, PictureGroundScale.Uniform(0.1), PixelFormat.Grey16);
        Assert.Equal(DetectorResult.NoColourPicture, _detector.Detect(input, _found).Refusal);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 200)]
    [InlineData(17, 9)]
    public void Detect_TinyPicture_FindsNone(int width, int height)
    {
        var input = new DetectorInput(
            new byte[width * height * 3], width, height, Classes, PictureGroundScale.Uniform(0.1));
        Assert.Equal(DetectorResult.Found(0), _detector.Detect(input, _found));
    }

    [Fact]
    public void Detect_NoiseAndSizesInTurn_FindsNone()
    {
        var random = new Random(9);
        foreach ((int width, int height) in ((int, int)[])[(640, 480), (101, 77), (320, 33), (640, 480)])
        {
            byte[] pixels = new byte[width * height * 3];
            random.NextBytes(pixels);
            var input = new DetectorInput(pixels, width, height, Classes, PictureGroundScale.Uniform(MetresPerPixel));
            Assert.Equal(0, _detector.Detect(input, _found).Count);
        }
    }

    [Fact]
    public void MissionFile_SecondColour_IsRead()
    {
        MissionPlan plan = MissionPlan.Parse(
            """
            {
              "area": [[47.0, 8.0], [47.001, 8.0], [47.001, 8.001]], "heightMetres": 40, "speedMetresPerSecond": 5,
              "laneSpacingMetres": 20,
              "targetClasses": { "gcp": { "colour": "#141414", "secondColour": "#f0f0f0", "minSideMetres": 0.3,
                "maxSideMetres": 0.52 } }
            }
            """,
            "field.json");
        TargetClass read = plan.TargetClasses.Single();
        Assert.True(read.IsPanel);
        Assert.Equal((20, 240), (read.Colour!.Red, read.SecondColour!.Blue));
    }

    private static TargetClass ClassOf(
        string name, (double Red, double Green, double Blue) colour,
        (double Red, double Green, double Blue)? second = null)
        => new(name) { Colour = RangeOf(colour), SecondColour = second is { } other ? RangeOf(other) : null };

    private static ColourRange RangeOf((double Red, double Green, double Blue) colour)
        => new((byte)colour.Red, (byte)colour.Green, (byte)colour.Blue);

    private static void Paint(
        Painting painting, TargetClass one, double x, double y, double side, double angle, bool isChequered)
    {
        (double, double, double) first = (one.Colour!.Red, one.Colour.Green, one.Colour.Blue);
        if (one.SecondColour is { } other)
            painting.TwoColours(first, (other.Red, other.Green, other.Blue), x, y, side, angle, isChequered);
        else
            painting.Rectangle(first, x, y, side, side, angle);
    }

    private static byte[] Shade(byte[] pixels, double light) => [.. pixels.Select(p => (byte)(p * light))];

    private static DetectorInput Input(byte[] picture, double metresPerPixel = MetresPerPixel)
        => new(picture, Painting.Width, Painting.Height, Classes, PictureGroundScale.Uniform(metresPerPixel));

    private sealed class Score
    {
        private double _squares;
        private double _turnSquares;
        private int _inside;

        public int Found { get; private set; }

        public int Of { get; private set; }

        public int False { get; private set; }

        public double MaxTurnDegrees { get; private set; }

        public double MeanTurnSquare => _turnSquares / Found;

        public double MeanSquare => _squares / Found;

        public double Inside => _inside / (double)Found;

        public void Add(ReadOnlySpan<TargetDetection> found, TargetClass one, double x, double y, double angle)
        {
            Of++;
            foreach (ref readonly TargetDetection f in found)
            {
                if (f.Class != one.Name || Math.Abs(f.CentreX - x) > 3 || Math.Abs(f.CentreY - y) > 3)
                    continue;
                Found++;
                False--;
                (double dx, double dy) = (f.CentreX - x, f.CentreY - y);
                double square = ((dx * dx) + (dy * dy)) / f.Covariance.ColumnColumn;
                _squares += square;
                _inside += square <= 5.991 ? 1 : 0;

                // Rows go south, so that turning clockwise in the picture is turning clockwise on the ground.
                TargetBearing bearing = f.Bearing!.Value;
                Assert.Equal(BearingSymmetry.QuarterTurn, bearing.Symmetry);
                Angle turn = bearing.DistanceTo(Angle.FromRadians(angle));
                MaxTurnDegrees = Math.Max(MaxTurnDegrees, turn.Degrees);
                _turnSquares += turn / bearing.Sigma * (turn / bearing.Sigma);
                return;
            }
        }

        public void Close(int count) => False += count;

        public override string ToString()
            => FormattableString.Invariant($"{Found} of {Of}, {False} false, NEES {MeanSquare:0.00}, ")
                + FormattableString.Invariant($"{100 * Inside:0} % inside, turned by {MaxTurnDegrees:0.0} at most")
                + FormattableString.Invariant($", NEES of that {MeanTurnSquare:0.00}");
    }
}
