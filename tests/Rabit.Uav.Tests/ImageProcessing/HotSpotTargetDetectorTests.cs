using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Rabit.Vision.Tests.Thermal;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Hot spots in painted thermal pictures: persons of 1.7 x 0.5 m, 14 x 4 pixels.</summary>
public sealed class HotSpotTargetDetectorTests(ITestOutputHelper output)
{
    private static readonly ImmutableArray<TargetClass> Persons =
    [
        new TargetClass("person")
        {
            HotSpot = new HotSpotTarget(),
            MinSideMetres = 0.5,
            MaxSideMetres = 1.4,
            MaxAspect = 5,
        },
    ];

    private readonly HotSpotTargetDetector _detector = new(Persons);
    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Fact]
    public void Detect_PersonsAnyhow_FindsThemWithATrueCovariance()
    {
        const int seed = 300;
        var random = new Random(seed);
        (int found, int of, int wrong, double squares, int inside) = (0, 0, 0, 0, 0);
        var turns = new List<double>();
        for (int picture = 0; picture < 25; picture++)
        {
            var scene = new ThermalScene(seed + picture);
            (double X, double Y, double Angle)[] places = [.. Enumerable.Range(0, 4).Select(i =>
                (40 + (70 * i) + (20 * random.NextDouble()), 40 + (170 * random.NextDouble()),
                    Math.PI * random.NextDouble()))];
            foreach ((double x, double y, double angle) in places)
                scene.Add(x, y, 1.7, 0.5, angle, 100 + (300 * random.NextDouble()));
            DetectorInput input = Input(scene.Finish());
            int count = _detector.Detect(input, _found).Count;
            Assert.All(_found.Take(count), f => Assert.Null(DetectionCheck.FindFault(f, input)));
            foreach ((double x, double y, double angle) in places)
            {
                of++;
                TargetDetection[] near = [.. _found.Take(count)
                    .Where(f => Math.Abs(f.CentreX - x) < 2 && Math.Abs(f.CentreY - y) < 2)];
                found += near.Length > 0 ? 1 : 0;
                wrong -= near.Length > 0 ? 1 : 0;
                if (near.Length == 0)
                    continue;
                double square = ErrorSquared(near[0], x, y);
                squares += square;
                inside += square <= 5.991 ? 1 : 0;
                Assert.InRange(near[0].SideMetres, 0.6, 1.25);
                TargetBearing bearing = near[0].Bearing!.Value;
                turns.Add(bearing.DistanceTo(AxisOf(angle)) / bearing.Sigma);
            }

            wrong += count;
        }

        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: {found} of {of} found, {wrong} false, NEES {squares / found:0.00}, {100.0 * inside / found:0} % inside"));
        Assert.True(found >= 0.98 * of && wrong == 0, $"seed {seed}: {found} of {of}, {wrong} false");
        Assert.InRange(squares / found, 0.8, 2.8);
        Assert.InRange((double)inside / found, 0.92, 1);
        double turnSquares = turns.Average(t => t * t);
        output.WriteLine(FormattableString.Invariant($"NEES of the bearing {turnSquares:0.00}, at most {turns.Max():0.0} sigma"));
        Assert.InRange(turnSquares, 0.2, 1.5);
    }

    // Columns go east and rows south: the first axis of the picture points to 90 degrees.
    private static Angle AxisOf(double angle) => Angle.FromRadians((Math.PI / 2) + angle);

    [Fact]
    public void Detect_WarmGroundThingsAndDefects_FindsNone()
    {
        var scene = new ThermalScene(2);
        scene.Add(80, 60, 6, 5, 0.3, 300);       // a roof
        scene.Add(200, 200, 25, 0.6, 0.1, 200);  // a pipe
        scene.Add(250, 60, 0.25, 0.2, 0, 500);   // a bird
        scene.Add(30, 200, 1.7, 0.5, 0, 20);     // hardly warmer than the ground
        scene.Add(1, 128, 1.7, 0.5, 0, 300);     // cut by the border
        for (int i = 0; i < 20; i++)
            scene.AddDefect(20 + (14 * i), 120 + (i % 5), 400 + (100 * i));
        DetectorResult result = _detector.Detect(Input(scene.Finish()), _found);
        Assert.True(
            result == DetectorResult.Found(0),
            string.Join("; ", _found.Take(result.Count).Select(f => $"{f.CentreX}, {f.CentreY}: {f.SideMetres} m")));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(1, 2500)]     // after the camera's calibration
    [InlineData(0.25, 100)]   // low gain
    [InlineData(2, -3000)]    // high gain
    public void Detect_StepOfGainOrOffset_FindsTheSame(double gain, double offset)
    {
        var scene = new ThermalScene(3);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 250);
        scene.Add(220, 150, 1.7, 0.5, 1.4, 150);
        Assert.Equal(DetectorResult.Found(2), _detector.Detect(Input(scene.Finish(gain, offset)), _found));
        Assert.Equal([100.0, 220], _found.Take(2).Select(f => Math.Round(f.CentreX)).OrderBy(x => x));
    }

    [Fact]
    public void Detect_Saturated_IsFoundWithALargerCovariance()
    {
        var scene = new ThermalScene(4);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 900);
        DetectorInput input = Input(scene.Finish(most: 16383));
        Assert.Equal(1, _detector.Detect(input, _found).Count);
        double clear = _found[0].Covariance.ColumnColumn;
        Assert.Equal(1, _detector.Detect(Input(scene.Finish(gain: 2.1)), _found).Count);
        Assert.True(_found[0].Covariance.ColumnColumn > 2 * clear);
        Assert.Equal((100.0, 90.0), (Math.Round(_found[0].CentreX), Math.Round(_found[0].CentreY)));
    }

    [Fact]
    public void Detect_TwoBesideEachOther_FindsBoth()
    {
        var scene = new ThermalScene(5);
        scene.Add(100, 90, 1.7, 0.5, 0, 250);
        scene.Add(100, 100, 1.7, 0.5, 0, 150);
        Assert.Equal(DetectorResult.Found(2), _detector.Detect(Input(scene.Finish()), _found));
    }

    [Fact]
    public void Detect_MinContrast_LeavesOutWhatIsLess()
    {
        var scene = new ThermalScene(6);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 250);
        scene.Add(220, 150, 1.7, 0.5, 1.4, 100);
        ImmutableArray<TargetClass> classes =
        [
            new TargetClass("person")
            {
                HotSpot = new HotSpotTarget { MinContrastCounts = 170 },
                MinSideMetres = 0.5,
                MaxSideMetres = 1.4,
                MaxAspect = 5,
            },
        ];
        Assert.Equal(1, new HotSpotTargetDetector(classes).Detect(Input(scene.Finish()), _found).Count);
        Assert.Equal(100, _found[0].CentreX, 0.5);
    }

    [Fact]
    public void Detect_ColourPicture_IsNotSearchedAndTheOtherWayRound()
    {
        var colour = new DetectorInput(
            new byte[300], 10, 10, Persons, PictureGroundScale.Uniform(0.1));
        Assert.Equal(HotSpotTargetDetector.NoThermalPicture, _detector.Detect(colour, _found).Refusal);
        var thermal = new DetectorInput(
            new byte[200], 10, 10, TargetClass.Defaults, PictureGroundScale.Uniform(0.1), PixelFormat.Grey16);
        Assert.Equal(
            DetectorResult.NoColourPicture,
            new ShapeTargetDetector(TargetClass.Defaults).Detect(thermal, new TargetDetection[4]).Refusal);
    }

    [Fact]
    public void FindFaults_WrongClassOrCamera_NamesIt()
    {
        var wrong = new TargetClass("warm")
        {
            HotSpot = new HotSpotTarget { MinContrastCounts = -1, MinSigmas = 2 },
            Colour = new ColourRange(1, 2, 3),
        };
        Assert.Equal(3, TargetClass.FindFaults([wrong]).Count());
        Assert.Contains(
            "has no hot spot, which the hot spot detector needs",
            Assert.Throws<ArgumentException>(() => new HotSpotTargetDetector(TargetClass.Defaults)).Message,
            StringComparison.Ordinal);
        var camera = new CameraModel { Width = 320, Height = 256, FocalX = 300, FocalY = 300 };
        var thermal = new CameraModel
        {
            Width = 320,
            Height = 256,
            FocalX = 300,
            FocalY = 300,
            Format = PixelFormat.Grey16,
        };
        string[] FaultsOf(CameraModel one, ImmutableArray<TargetClass> classes)
            => [.. new ImageProcessingOptions { Camera = one, TargetClasses = classes }.FindFaults(hasCamera: true)];
        Assert.Contains("is a hot spot, and the camera is no thermal one", Assert.Single(FaultsOf(camera, Persons)),
            StringComparison.Ordinal);
        Assert.Contains("no target class is a hot spot", Assert.Single(FaultsOf(thermal, TargetClass.Defaults)),
            StringComparison.Ordinal);
        Assert.Empty(FaultsOf(thermal, [.. TargetClass.Defaults, .. Persons]));
    }

    [Fact]
    public void MissionFile_HotSpot_IsRead()
    {
        MissionPlan plan = MissionPlan.Parse(
            """
            {
              "area": [[47.0, 8.0], [47.001, 8.0], [47.001, 8.001]], "heightMetres": 40, "speedMetresPerSecond": 5,
              "laneSpacingMetres": 20,
              "targetClasses": { "person": { "hotSpot": { "minContrastCounts": 40 }, "maxAspect": 5 } }
            }
            """,
            "field.json");
        HotSpotTarget read = plan.TargetClasses.Single().HotSpot!;
        Assert.Equal((40.0, 6.0), (read.MinContrastCounts, read.MinSigmas));
    }

    private static DetectorInput Input(byte[] picture)
        => new(
            picture, ThermalScene.Width, ThermalScene.Height, Persons,
            PictureGroundScale.Uniform(ThermalScene.MetresPerPixel), PixelFormat.Grey16);

    private static double ErrorSquared(in TargetDetection found, double x, double y)
    {
        (double dx, double dy) = (found.CentreX - x, found.CentreY - y);
        PixelCovariance p = found.Covariance;
        double determinant = (p.ColumnColumn * p.RowRow) - (p.ColumnRow * p.ColumnRow);
        return ((p.RowRow * dx * dx) - (2 * p.ColumnRow * dx * dy) + (p.ColumnColumn * dy * dy)) / determinant;
    }
}
