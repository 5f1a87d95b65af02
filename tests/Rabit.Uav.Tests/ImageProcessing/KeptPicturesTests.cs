using System;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Pictures that a flight keeps: which, under which names, and what each says of itself.</summary>
public sealed class KeptPicturesTests : IDisposable
{
    private readonly string _folder = Path.Combine(Path.GetTempPath(), $"rabit-kept-{Guid.NewGuid():N}");

    public void Dispose()
    {
        if (Directory.Exists(_folder))
            Directory.Delete(_folder, recursive: true);
    }

    // A tilted vehicle, and a lens with radial and tangential distortion.
    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(0.1, -0.15, 2)]
    [InlineData(-0.2, 0.1, -1)]
    public void Picture_ByItself_GivesTheSamePlaceAsTheFlight(double roll, double pitch, double yaw)
    {
        var reported = new TargetDetection
        {
            Class = DefaultTargetClasses.Red,
            CentreX = 500,
            CentreY = 90,
            WidthPixels = 12,
            HeightPixels = 12,
            Score = 0.9,
            Covariance = PixelCovariance.FromSigma(0.5),
        };
        using ImagingRig rig = Rig(new KeptPictureOptions { Folder = _folder }, reported);
        rig.View.Attitude = EulerAngles.FromRadians(roll, pitch, yaw);
        Fly(rig, pictures: 1);

        TargetReport report = Assert.Single(rig.Sink.Reports);
        string file = Assert.Single(Directory.GetFiles(_folder));
        Assert.Matches("^f000000_[0-9]+_e[0-9]+[.]png$", Path.GetFileName(file));
        byte[] bytes = File.ReadAllBytes(file);
        Assert.Equal(ImagingRig.Grass, PngPicture.Decode(bytes, file).Pixels);
        PhotoMetadata said = PhotoMetadata.Read(bytes, file);
        Assert.Empty(said.Faults);
        NedPosition place = Place(said, reported.CentreX, reported.CentreY);
        NedPosition expected = LocalNedFrame.IgnoringGeoid(
            GeodeticPosition.FromDegrees(said.LatitudeDegrees!.Value, said.LongitudeDegrees!.Value, 0))
            .ToNed(report.Position);
        Assert.Equal(expected.North, place.North, 0.01);
        Assert.Equal(expected.East, place.East, 0.01);
        Assert.True(PictureFileName.TryParse(Path.GetFileName(file), out PictureFileName name));
        double middle = (name.StartUtcMicroseconds + (name.ExposureMicroseconds / 2.0)) / 1e6;
        Assert.Equal(middle, (said.Taken!.Value - PictureFolderWriter.Epoch).TotalSeconds, 1e-4);
        Assert.Equal((1L, 0L), (Counts(rig).Kept, Counts(rig).NotKept));
    }

    [Theory]
    [InlineData(false, 0)]
    [InlineData(true, 3)]
    public void Picture_NothingReported_IsKeptWhereAllAre(bool keepsAll, int kept)
    {
        using ImagingRig rig = Rig(new KeptPictureOptions { Folder = _folder, KeepsAll = keepsAll });
        Fly(rig, pictures: 3);
        Assert.Equal(kept, Directory.GetFiles(_folder).Length);
        Assert.Equal(kept, Counts(rig).Kept);
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Picture_NoMoreBytesAllowed_IsCountedAndLogged()
    {
        using ImagingRig rig = Rig(
            new KeptPictureOptions { Folder = _folder, KeepsAll = true, MaxBytes = 1_000_000 });
        Fly(rig, pictures: 4);
        KeptPictureCounts counts = Counts(rig);
        Assert.Equal(4, counts.Kept + counts.NotKept);
        Assert.InRange(counts.NotKept, 1, 3);
        Assert.Equal(PictureKeeper.Full, counts.LastFault);
        Assert.Single(rig.Log, l => l.Contains("a picture is not kept: " + PictureKeeper.Full));
        Assert.True(Directory.GetFiles(_folder).Sum(f => new FileInfo(f).Length) <= 1_000_000);
    }

    [Fact]
    public void Folder_IsGoneInFlight_IsMadeAgain()
    {
        using ImagingRig rig = Rig(new KeptPictureOptions { Folder = _folder, KeepsAll = true });
        Directory.Delete(_folder);
        Fly(rig, pictures: 2);
        Assert.Equal(2, Directory.GetFiles(_folder).Length);
    }

    [Fact]
    public void Folder_CannotBeWritten_IsRefusedAtTheStart()
    {
        File.WriteAllText(_folder, "a file");
        try
        {
            string text = Assert.Throws<ArgumentException>(
                () => Rig(new KeptPictureOptions { Folder = _folder })).Message;
            Assert.Contains($"the folder of the kept pictures, {_folder}, cannot be written", text);
        }
        finally
        {
            File.Delete(_folder);
        }
    }

    [Fact]
    public void Options_OutOfRange_AreNamed()
    {
        var options = new ImageProcessingOptions
        {
            KeptPictures = new KeptPictureOptions { Folder = " ", MaxBytes = 0, PicturesWaiting = 0 },
        };
        string faults = string.Join("; ", options.FindFaults(hasCamera: false));
        Assert.Contains("the folder of the kept pictures is empty", faults);
        Assert.Contains("MaxBytes of the kept pictures is 0", faults);
        Assert.Contains("PicturesWaiting is 0", faults);
    }

    private static KeptPictureCounts Counts(ImagingRig rig) => rig.Manager.SummariseKeptPictures()!.Value;

    private static ImagingRig Rig(KeptPictureOptions kept, params TargetDetection[] found)
        => ImagingRig.Search(
            ImagingRig.Grass,
            new ImageProcessingOptions { Detector = new FixedDetector(found), KeptPictures = kept });

    private static void Fly(ImagingRig rig, int pictures)
    {
        rig.AddPoses(0, pictures + 2);
        for (int i = 0; i < pictures; i++)
            rig.Camera!.Add(i, i + 1, i + 1.1);
        rig.Run(pictures + 3);
    }

    // What any program that knows EXIF and XMP would do.
    private static NedPosition Place(PhotoMetadata said, double column, double row)
    {
        PhotoLens lens = said.Lens!;
        var camera = new CameraModel
        {
            Width = said.Width!.Value,
            Height = said.Height!.Value,
            FocalX = lens.FocalX,
            FocalY = lens.FocalY,
            CentreX = ((said.Width!.Value - 1) / 2.0) + lens.CentreOffsetX,
            CentreY = ((said.Height!.Value - 1) / 2.0) + lens.CentreOffsetY,
            K1 = lens.K1,
            K2 = lens.K2,
            P1 = lens.P1,
            P2 = lens.P2,
            K3 = lens.K3,
        };
        Assert.True(camera.TryUndistort(column, row, out double x, out double y));
        Rotation nedFromGimbal = Rotation.FromEuler(EulerAngles.FromDegrees(
            said.GimbalRollDegrees!.Value, said.GimbalPitchDegrees!.Value, said.GimbalYawDegrees!.Value));
        (double north, double east, double down) = nedFromGimbal.Apply(1, x, y);
        double scale = said.RelativeAltitudeMetres!.Value / down;
        return new NedPosition(scale * north, scale * east, 0);
    }

    private sealed class FixedDetector(TargetDetection[] found) : ITargetDetector
    {
        public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
        {
            found.CopyTo(detections);
            return DetectorResult.Found(found.Length);
        }
    }
}
