using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Image Processing with a detector of the user's, also one that does what it should not.</summary>
public sealed class OwnDetectorTests
{
    private static readonly TargetClass Person = new("person") { MinSideMetres = 0.3, MaxSideMetres = 2 };

    [Fact]
    public void Detector_OfTheUser_ItsDetectionsAreReportedWithTheirPlace()
    {
        using ImagingRig rig = Rig(Good);
        Fly(rig, pictures: 1);

        TargetReport report = Assert.Single(rig.Sink.Reports);
        Assert.Equal(("person", 0.7), (report.Class.ToString(), report.Score));
        Assert.Equal(12, report.MarkerId);
        NedPosition ned = LocalNedFrame.IgnoringGeoid(rig.View.Position).ToNed(report.Position);
        Assert.True(rig.View.TryProject(ned.North, ned.East, out double column, out double row));
        Assert.Equal((200, 150), (Math.Round(column), Math.Round(row)));

        // 20 x 10 pixels from 40 m with a focal length of 530 pixels.
        Assert.Equal(Math.Sqrt(200) * 40 / 530, report.SizeMetres, 0.05);
    }

    [Fact]
    public void Detector_Throws_ThePictureIsNotSearchedAndTheManagerGoesOn()
    {
        int calls = 0;
        using ImagingRig rig = Rig(
            input => ++calls == 1 ? throw new InvalidOperationException("no model") : Good(input));
        Fly(rig, pictures: 2);

        ImagingStatus status = rig.Status;
        Assert.Equal((1L, 1L, 1L), (status.DetectorFailures, status.FramesRefused, status.Observations));
        Assert.Equal(
            ("the detector threw InvalidOperationException: no model", "the detector failed"),
            (status.LastDetectorFault, status.LastRefusal));
        Assert.Equal(1, Assert.Single(rig.Sink.Observations).Number);
        Assert.Single(rig.Log, text => string.Equals(text, status.LastDetectorFault, StringComparison.Ordinal));
        rig.AssertAllGivenBack();
        Assert.Equal(0, rig.Finish().ExitCode);
    }

    // An exception is the user's code too, as those of wrapped native libraries: its message has several lines, or
    // throws itself.
    [Theory]
    [InlineData("no model\r\nat line 1\n", "the detector threw ForeignException: no model at line 1 ")]
    [InlineData(null, "the detector threw ForeignException: (its message cannot be read: InvalidOperationException)")]
    public void Detector_ThrowsForeignException_IsOneLineOfTheLog(string? message, string line)
    {
        int calls = 0;
        using ImagingRig rig = Rig(input => ++calls == 1 ? throw new ForeignException(message) : Good(input));
        Fly(rig, pictures: 2);

        Assert.Equal((1L, 1L), (rig.Status.DetectorFailures, rig.Status.Observations));
        Assert.Equal(line, rig.Status.LastDetectorFault);
        rig.AssertAllGivenBack();
        Assert.Equal(0, rig.Finish().ExitCode);
    }

    [Fact]
    public void Detector_ThrowsAnEndlessMessage_ItIsCutShort()
    {
        using ImagingRig rig = Rig(_ => throw new InvalidOperationException(new string('x', 1_000_000)));
        Fly(rig, pictures: 1);
        Assert.InRange(rig.Status.LastDetectorFault!.Length, 1000, 2100);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(17)]
    [InlineData(int.MaxValue)]
    public void Detector_ReturnsAnImpossibleCount_ThePictureIsNotSearched(int count)
    {
        using ImagingRig rig = Rig(_ => count);
        Fly(rig, pictures: 1);
        Assert.Equal((1L, 0L), (rig.Status.DetectorFailures, rig.Status.Observations));
        Assert.Empty(rig.Sink.Observations);
    }

    [Fact]
    public void Detector_RefusesThePicture_IsNoFault()
    {
        using var rig = new ImagingRig(
            new ScriptedCamera(ImagingRig.Grass),
            Options(new ScriptedDetector((_, _) => DetectorResult.NotSearched("too dark"))));
        rig.Order(ImagingMode.Search);
        Fly(rig, pictures: 1);
        Assert.Equal(
            (0L, 1L, "too dark"), (rig.Status.DetectorFailures, rig.Status.FramesRefused, rig.Status.LastRefusal));
    }

    [Theory]
    [InlineData("NaN", DetectionCheck.OutsidePicture)]
    [InlineData("outside", DetectionCheck.OutsidePicture)]
    [InlineData("class", DetectionCheck.WrongClass)]
    [InlineData("no class", DetectionCheck.WrongClass)]
    [InlineData("score", DetectionCheck.WrongScore)]
    [InlineData("score NaN", DetectionCheck.WrongScore)]
    [InlineData("extent", DetectionCheck.WrongExtent)]
    [InlineData("side", DetectionCheck.WrongSide)]
    [InlineData("bearing", DetectionCheck.WrongBearing)]
    [InlineData("bearing without error", DetectionCheck.WrongBearing)]
    [InlineData("no covariance", DetectionCheck.WrongCovariance)]
    [InlineData("covariance", DetectionCheck.WrongCovariance)]
    public void Detection_NotValid_IsLeftOutAndCounted(string what, string fault)
    {
        TargetDetection wrong = what switch
        {
            "NaN" => Detection() with { CentreX = double.NaN },
            "outside" => Detection() with { CentreY = 480 },
            "class" => Detection() with { Class = DefaultTargetClasses.Red },
            "no class" => Detection() with { Class = default },
            "score" => Detection() with { Score = 1.01 },
            "score NaN" => Detection() with { Score = double.NaN },
            "extent" => Detection() with { WidthPixels = -1 },
            "side" => Detection() with { SideMetres = double.PositiveInfinity },
            "bearing" => Detection() with { Bearing = Bearing(Angle.NaN, Angle.FromDegrees(1)) },
            "bearing without error" => Detection() with { Bearing = Bearing(Angle.FromDegrees(1), Angle.Zero) },
            "no covariance" => Detection() with { Covariance = default },
            _ => Detection() with { Covariance = new PixelCovariance(1, 1.1, 1) },
        };
        var detector = new ScriptedDetector((_, found) =>
        {
            (found[0], found[1]) = (wrong, Detection());
            return DetectorResult.Found(2);
        });
        using var rig = new ImagingRig(new ScriptedCamera(ImagingRig.Grass), Options(detector));
        rig.Order(ImagingMode.Search);
        Fly(rig, pictures: 1);

        Assert.Equal((1L, 1L, fault), (rig.Status.DetectionsRefused, rig.Status.Reports, rig.Status.LastDetectorFault));
        Assert.Equal(0, Assert.Single(rig.Sink.Reports).Index);
    }

    [Fact]
    public void Detection_CutByTheBorder_IsNotReportedButCounted()
    {
        var detector = new ScriptedDetector((_, found) =>
        {
            (found[0], found[1]) = (Detection() with { IsCut = true }, Detection());
            return DetectorResult.Found(2);
        });
        using var rig = new ImagingRig(new ScriptedCamera(ImagingRig.Grass), Options(detector));
        rig.Order(ImagingMode.Search);
        Fly(rig, pictures: 1);

        Assert.Equal(
            (1L, 1L, 0L, 0L),
            (rig.Status.DetectionsCut, rig.Status.Reports, rig.Status.ReportsDropped, rig.Status.DetectionsRefused));
        Assert.Equal(0, Assert.Single(rig.Sink.Reports).Index);
    }

    [Fact]
    public void Detection_MoreUncertain_ItsReportIsToo()
    {
        HorizontalCovariance At(PixelCovariance pixels)
        {
            using ImagingRig rig = Rig(input => 1, Detection() with { Covariance = pixels });
            Fly(rig, pictures: 1);
            return Assert.Single(rig.Sink.Reports).Covariance;
        }

        HorizontalCovariance half = At(PixelCovariance.FromSigma(0.5));
        HorizontalCovariance tilted = At(new PixelCovariance(100, 50, 100));

        // North of straight down with the nose north: rows go south, columns east, 0.075 m each.
        double scale = 40.0 / 530;
        Assert.Equal((100 - 0.25) * scale * scale, tilted.NorthNorth - half.NorthNorth, 0.03);
        Assert.Equal((100 - 0.25) * scale * scale, tilted.EastEast - half.EastEast, 0.03);
        Assert.Equal(-50 * scale * scale, tilted.NorthEast - half.NorthEast, 0.03);
    }

    [Fact]
    public void Command_ClassThatIsNotDeclared_IsInTheStatus()
    {
        using ImagingRig rig = Rig(Good);
        rig.Order(ImagingMode.Search, new TargetClassName("persn"));
        Fly(rig, pictures: 1);
        Assert.Equal(("persn", PictureSearch.NoClasses), (rig.Status.UnknownClasses, rig.Status.LastRefusal));

        rig.Order(ImagingMode.Search, Person.Name);
        rig.Camera!.Add(9, 2.5, 2.6);
        rig.Run(2);
        Assert.Null(rig.Status.UnknownClasses);
        Assert.Equal(1, rig.Status.Observations);
    }

    [Fact]
    public void Detector_LongerThanItsBudget_IsCountedAndItsDetectionsAreUsed()
    {
        TimeSpan now = TimeSpan.Zero;
        var detector = new ScriptedDetector((_, found) =>
        {
            now += TimeSpan.FromMilliseconds(300);
            found[0] = Detection();
            return DetectorResult.Found(1);
        });
        var runner = new DetectorRunner(detector, TimeSpan.FromMilliseconds(299), maxDetections: 4, () => now);
        var input = new DetectorInput(
            ImagingRig.Grass, Painting.Width, Painting.Height, [Person], PictureGroundScale.Uniform(0.1));

        Assert.Null(runner.Run(input));
        Assert.Equal((1L, 1), (runner.Overruns, runner.Found.Length));
        runner = new DetectorRunner(detector, TimeSpan.FromMilliseconds(300), maxDetections: 4, () => now);
        Assert.Null(runner.Run(input));
        Assert.Equal(0, runner.Overruns);
    }

    private static TargetBearing Bearing(Angle angle, Angle sigma) => new(angle, sigma, BearingSymmetry.HalfTurn);

    private static int Good(DetectorInput input)
    {
        Assert.Equal(
            (Painting.Width, Painting.Height, Painting.Width * 3), (input.Width, input.Height, input.StrideBytes));
        Assert.Equal([Person], input.Classes.ToArray());
        Assert.True(input.GroundScale.TryAt(320, 240, out Rabit.Uav.CameraGeometry.GroundScale scale));
        Assert.Equal(40.0 / 530, Math.Sqrt(scale.PixelArea), 0.005);
        return 1;
    }

    private static TargetDetection Detection() => new()
    {
        Class = Person.Name,
        MarkerId = 12,
        CentreX = 200,
        CentreY = 150,
        WidthPixels = 20,
        HeightPixels = 10,
        Score = 0.7,
        Covariance = PixelCovariance.FromSigma(2),
    };

    private static ImageProcessingOptions Options(ITargetDetector detector)
        => new() { Detector = detector, TargetClasses = [Person] };

    private static ImagingRig Rig(Func<DetectorInput, int> count, TargetDetection? detection = null)
    {
        var detector = new ScriptedDetector((input, found) =>
        {
            found[0] = detection ?? Detection();
            return DetectorResult.Found(count(input));
        });
        return ImagingRig.Search(ImagingRig.Grass, Options(detector));
    }

    private static void Fly(ImagingRig rig, int pictures)
    {
        rig.AddPoses(0, 9);
        for (int i = 0; i < pictures; i++)
            rig.Camera!.Add(i, 1 + (0.2 * i), 1.1 + (0.2 * i));
        rig.Run(2);
    }

    private sealed class ForeignException(string? message) : Exception
    {
        public override string Message => message ?? throw new InvalidOperationException();
    }

    private delegate DetectorResult Script(in DetectorInput input, Span<TargetDetection> found);

    private sealed class ScriptedDetector : ITargetDetector
    {
        private readonly Script _script;

        public ScriptedDetector(Func<DetectorInput, TargetDetection[], DetectorResult> script)
        {
            _script = (in DetectorInput input, Span<TargetDetection> found) =>
            {
                var copy = new TargetDetection[found.Length];
                DetectorResult result = script(input, copy);
                copy.CopyTo(found);
                return result;
            };
        }

        public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
            => _script(input, detections);
    }
}
