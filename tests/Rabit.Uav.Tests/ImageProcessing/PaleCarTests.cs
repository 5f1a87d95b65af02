using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>White and silver cars from 18 m above them, where one may fill a tile of the light.</summary>
public sealed class PaleCarTests
{
    private const double MetresPerPixel = 18.0 / 530;

    private static readonly (double, double, double) Glass = (30, 36, 42);
    private static readonly (double, double, double) TailLight = (205, 28, 32);

    [Theory]
    [InlineData(168, 172, 176, 1, 1)]
    [InlineData(168, 172, 176, 1.06, 0.94)]
    [InlineData(168, 172, 176, 0.95, 1.06)]
    [InlineData(232, 232, 228, 1, 1)]
    [InlineData(232, 232, 228, 1.06, 0.94)]
    [InlineData(232, 232, 228, 0.95, 1.06)]
    public void Detect_InUsualAndTintedLight_FindsTheCar(
        byte red, byte green, byte blue, double redGain, double blueGain)
    {
        for (int seed = 1; seed <= 3; seed++)
        {
            var painting = new Painting(seed);
            Paint(painting, (red, green, blue), 150 + (70 * seed), 140 + (50 * seed), 0.4 * seed);
            byte[] picture = painting.Finish();
            for (int at = 0; at < picture.Length; at += 3)
            {
                picture[at] = Scaled(picture[at], redGain);
                picture[at + 2] = Scaled(picture[at + 2], blueGain);
            }

            TargetDetection car = Assert.Single(Search(picture, new ColourRange(red, green, blue)));
            Assert.Equal("car", car.Class.ToString());
            Assert.InRange(car.CentreX, 150 + (70 * seed) - 3, 150 + (70 * seed) + 3);
            Assert.InRange(car.CentreY, 140 + (50 * seed) - 3, 140 + (50 * seed) + 3);
        }
    }

    /// <summary>A tile has 80 x 60 pixels: a car of 130 x 53 fills most of the one in whose middle it stands.</summary>
    [Fact]
    public void Detect_InTheMiddleOfATile_FindsTheCar()
    {
        var painting = new Painting(5);
        Paint(painting, (168, 172, 176), 280, 210, 0);

        Assert.Equal("car", Assert.Single(Search(painting.Finish(), new ColourRange(168, 172, 176))).Class.ToString());
    }

    /// <summary>A road of pale asphalt is the ground there, and no part of a silver car on it.</summary>
    [Fact]
    public void Detect_OnAPaleRoad_FindsTheCar()
    {
        var painting = new Painting(6);
        painting.Rectangle((138, 138, 130), 280, 240, 90, 700, 0);
        Paint(painting, (190, 194, 198), 280, 210, 1.57);

        Assert.Equal("car", Assert.Single(Search(painting.Finish(), new ColourRange(168, 172, 176))).Class.ToString());
    }

    /// <summary>
    /// A slab of concrete of the size and form of a car is none: it is too dark to be white, or too warm.
    /// </summary>
    [Theory]
    [InlineData(165, 160, 146)]
    [InlineData(215, 195, 150)]
    public void Detect_SlabOfConcrete_IsNoWhiteCar(byte red, byte green, byte blue)
    {
        var painting = new Painting(4);
        painting.Rectangle((red, green, blue), 320, 240, 4.4 / MetresPerPixel, 1.8 / MetresPerPixel, 0.3);

        Assert.Empty(Search(painting.Finish(), new ColourRange(232, 232, 228)));
    }

    // Seen from above: the windows at the front, at the back and at the sides, and the lights.
    private static void Paint(Painting painting, (double, double, double) paint, double x, double y, double angle)
    {
        void Part((double, double, double) colour, double ahead, double aside, double length, double width)
            => painting.Rectangle(
                colour, x + (((ahead * Math.Cos(angle)) - (aside * Math.Sin(angle))) / MetresPerPixel),
                y + (((ahead * Math.Sin(angle)) + (aside * Math.Cos(angle))) / MetresPerPixel),
                length / MetresPerPixel, width / MetresPerPixel, angle);

        Part(paint, 0, 0, 4.4, 1.8);
        Part(Glass, 0.7, 0, 0.6, 1.2);
        Part(Glass, -1.1, 0, 0.4, 1.2);
        Part(Glass, -0.2, 0.7, 1.2, 0.2);
        Part(Glass, -0.2, -0.7, 1.2, 0.2);
        Part(TailLight, -2.1, 0.7, 0.2, 0.2);
        Part(TailLight, -2.1, -0.7, 0.2, 0.2);
    }

    private static byte Scaled(byte level, double gain) => (byte)Math.Min(255, level * gain);

    private static TargetDetection[] Search(byte[] picture, ColourRange colour)
    {
        ImmutableArray<TargetClass> classes =
        [
            .. TargetClass.Defaults,
            new("car")
            {
                Colour = colour, MinSideMetres = 2.3, MaxSideMetres = 3.6, MinAspect = 1.7, MaxAspect = 3.2,
                MinColourShare = 0.65,
            },
        ];
        var detections = new TargetDetection[16];
        DetectorResult result = new ShapeTargetDetector(classes).Detect(
            new DetectorInput(
                picture, Painting.Width, Painting.Height, classes, PictureGroundScale.Uniform(MetresPerPixel)),
            detections);
        return detections.Take(result.Count).ToArray();
    }
}
