using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision.Tests.Thermal;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>A thermal camera in the manager: its hot spots are reported, and one that is broken is noticed.</summary>
public sealed class ThermalImagingTests
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

    [Fact]
    public void Frame_WithAPerson_IsReportedWithItsPlaceAndPictures()
    {
        var scene = new ThermalScene(3);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 250);
        using ImagingRig rig = Search(scene.Finish());
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(2);

        TargetReport report = Assert.Single(rig.Sink.Reports);
        Assert.Equal("person", report.Class.ToString());
        NedPosition ned = LocalNedFrame.IgnoringGeoid(rig.View.Position).ToNed(report.Position);
        double metresPerPixel = rig.View.HeightMetres / 333;
        Assert.Equal((127.5 - 90) * metresPerPixel, ned.North - rig.View.Mount.GimbalLeverArmMetres.Forward, 0.05);
        Assert.Equal((100 - 159.5) * metresPerPixel, ned.East, 0.05);

        ImageChip chip = Assert.Single(rig.Manager.ImageChips);
        byte[] pixels = chip.CopyPixels();
        int warmest = 3 * (((chip.Height / 2) * chip.Width) + (chip.Width / 2));
        Assert.True(pixels[warmest] > 200 && pixels[0] < 100, $"{pixels[warmest]} in the middle, {pixels[0]} beside it");
        Assert.NotNull(rig.Manager.FindPictureOverview(0));
        ImagingStatus status = rig.Status;
        Assert.Equal(1, status.LastPicture!.Value.Detections);
        Assert.Equal(2.0, status.LastPicture.Value.Exposure.TotalMilliseconds);
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Frame_CameraRepeatsOnePicture_IsFrozen()
    {
        using ImagingRig rig = Search(new ThermalScene(3).Finish());
        Fly(rig);
        ImagingStatus status = rig.Status;
        Assert.Equal((1L, 7L), (status.Pictures.Of(PictureQuality.Usable), status.Pictures.Of(PictureQuality.Frozen)));
        Assert.Equal(PictureQuality.Frozen, status.UnusableCause);
    }

    [Fact]
    public void Frame_CameraGivesOneValue_IsUniform()
    {
        byte[] picture = new byte[ThermalScene.Width * ThermalScene.Height * 2];
        for (int i = 0; i < picture.Length; i++)
            picture[i] = 0x1C;
        using ImagingRig rig = Search(picture);
        Fly(rig);
        Assert.Equal(8, rig.Status.Pictures.Of(PictureQuality.Uniform));
    }

    private static void Fly(ImagingRig rig)
    {
        for (int i = 0; i <= 50; i++)
        {
            GeodeticPosition at = GeodeticPosition.FromRadians(0.8 + (i * 0.5 / 6_378_000), 0.15, 540);
            rig.AddPose(i / 10.0, at, new NedVector(5, 0, 0), default, default);
        }

        for (int i = 0; i < 8; i++)
            rig.Camera!.Add(i, 1 + (i * 0.45), 1.1 + (i * 0.45));
        rig.Run(5);
    }

    private static ImagingRig Search(byte[] picture)
    {
        var camera = new ScriptedCamera(picture)
        {
            Format = PixelFormat.Grey16,
            Size = (ThermalScene.Width, ThermalScene.Height),
        };
        var rig = new ImagingRig(camera, new ImageProcessingOptions
        {
            TargetClasses = Persons,
            Camera = new CameraModel
            {
                Width = ThermalScene.Width,
                Height = ThermalScene.Height,
                Format = PixelFormat.Grey16,
                FocalX = 333,
                FocalY = 333,
                CentreX = 159.5,
                CentreY = 127.5,
            },
        });
        rig.Order(ImagingMode.Search);
        return rig;
    }
}
