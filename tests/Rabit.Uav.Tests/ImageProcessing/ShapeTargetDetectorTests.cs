using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class ShapeTargetDetectorTests
{
    /// <summary>What is tiny where it lies is left out, however far the top of the picture reaches.</summary>
    [Fact]
    public void Detect_ThousandsOfTinySpotsInAPictureThatReachesFar_FindsThePanelAmongThem()
    {
        var view = new TestView { CameraPitch = -Math.PI / 4, Attitude = EulerAngles.FromRadians(0, 0.25, 0) };
        (TargetDetection[] found, DetectorResult result) = Search(view, spots: 4000);

        Assert.Null(result.Refusal);
        Assert.Equal(DefaultTargetClasses.Blue, Assert.Single(found).Class);
    }

    /// <summary>
    /// Dry grass from 95 m has thousands of spots that may be yellow, each as large as what is seen of a panel at the
    /// least: such pictures were refused, and the mission was aborted.
    /// </summary>
    [Fact]
    public void Detect_ThousandsOfSpotsThatMayBePartsOfPanels_FindsThePanelAmongThem()
    {
        var painting = new Painting(31);
        (double red, double green, double blue) = Painting.Nominal(DefaultTargetClasses.Yellow);
        for (int i = 0; i < 6000; i++)
        {
            int at = (((10 + (4 * (i / 150))) * Painting.Width) + 20 + (4 * (i % 150))) * 3;
            foreach (int pixel in new[] { at, at + 3, at + (3 * Painting.Width), at + 3 + (3 * Painting.Width) })
            {
                painting.Pixels[pixel] = (byte)red;
                painting.Pixels[pixel + 1] = (byte)green;
                painting.Pixels[pixel + 2] = (byte)blue;
            }
        }

        painting.Rectangle(Painting.Nominal(DefaultTargetClasses.Blue), 320, 400, 6, 6, 0);
        var detections = new TargetDetection[1024];
        DetectorResult result = new ShapeTargetDetector(TargetClass.Defaults).Detect(
            new DetectorInput(
                painting.Pixels, Painting.Width, Painting.Height, TargetClass.Defaults,
                PictureGroundScale.Uniform(0.18)),
            detections);

        Assert.Null(result.Refusal);
        Assert.Contains(detections.Take(result.Count), d => d.Class == DefaultTargetClasses.Blue);
    }

    /// <summary>Red soil is not white ground in red light, in which they would be yellow.</summary>
    [Fact]
    public void Detect_OrangeAndRedOnRedSoil_AreFoundByTheirColours()
    {
        var painting = new Painting(32);
        for (int at = 0; at < painting.Pixels.Length; at += 3)
        {
            (double red, double blue) = (1.7 * painting.Pixels[at + 1], 0.65 * painting.Pixels[at + 1]);
            (painting.Pixels[at], painting.Pixels[at + 2]) = ((byte)Math.Min(255, red), (byte)blue);
        }

        painting.Rectangle(Painting.Nominal(DefaultTargetClasses.Orange), 200, 200, 20, 20, 0.3);
        painting.Rectangle(Painting.Nominal(DefaultTargetClasses.Red), 400, 250, 20, 20, 0.7);
        var detections = new TargetDetection[16];
        DetectorResult result = new ShapeTargetDetector(TargetClass.Defaults).Detect(
            new DetectorInput(
                painting.Pixels, Painting.Width, Painting.Height, TargetClass.Defaults,
                PictureGroundScale.Uniform(0.05)),
            detections);

        Assert.Equal(
            [DefaultTargetClasses.Orange, DefaultTargetClasses.Red],
            detections.Take(result.Count).OrderBy(d => d.CentreX).Select(d => d.Class));
    }

    /// <summary>More than there is room for: the likeliest stay, and what is left out is counted.</summary>
    [Fact]
    public void Detect_MorePanelsThanThereIsRoomFor_FindsTheClearestAmongThemAndCountsTheRest()
    {
        var painting = new Painting(33);
        for (int i = 0; i < 560; i++)
        {
            (int left, int top) = (20 + (12 * (i % 50)), 20 + (12 * (i / 50)));
            for (int pixel = 0; pixel < 54; pixel++)
            {
                int at = (((top + (pixel / 6)) * Painting.Width) + left + (pixel % 6)) * 3;
                (painting.Pixels[at], painting.Pixels[at + 1], painting.Pixels[at + 2]) = (205, 28, 32);
            }
        }

        painting.Rectangle(Painting.Nominal(DefaultTargetClasses.Blue), 320, 450, 9, 9, 0);
        var detections = new TargetDetection[1024];
        DetectorResult result = new ShapeTargetDetector(TargetClass.Defaults).Detect(
            new DetectorInput(
                painting.Pixels, Painting.Width, Painting.Height, TargetClass.Defaults,
                PictureGroundScale.Uniform(0.1)),
            detections);

        Assert.Null(result.Refusal);
        Assert.True(
            detections.Take(result.Count).Any(d => d.Class == DefaultTargetClasses.Blue),
            $"{result.Count} found, {result.Dropped} dropped");
        Assert.InRange(result.Dropped, 1, 700);
    }

    private static (TargetDetection[] Found, DetectorResult Result) Search(TestView view, int spots)
    {
        var painting = new Painting(31);
        (double red, double green, double blue) = Painting.Nominal(DefaultTargetClasses.Red);
        for (int i = 0; i < spots; i++)
        {
            int at = (((260 + (4 * (i / 100))) * Painting.Width) + 100 + (4 * (i % 100))) * 3;
            foreach (int pixel in new[] { at, at + 3, at + (3 * Painting.Width), at + 3 + (3 * Painting.Width) })
            {
                painting.Pixels[pixel] = (byte)red;
                painting.Pixels[pixel + 1] = (byte)green;
                painting.Pixels[pixel + 2] = (byte)blue;
            }
        }

        painting.Rectangle(Painting.Nominal(DefaultTargetClasses.Blue), 320, 450, 26, 21, 0);
        var detections = new TargetDetection[16];
        (_, Rotation nedFromCamera) = view.Projection(new ErrorBudget()).CameraPose();
        var input = new DetectorInput(
            painting.Pixels, Painting.Width, Painting.Height, TargetClass.Defaults,
            PictureGroundScale.OfLevelGround(view.Camera, nedFromCamera, 20));
        DetectorResult result = new ShapeTargetDetector(TargetClass.Defaults).Detect(input, detections);
        return (detections.Take(result.Count).ToArray(), result);
    }
}
