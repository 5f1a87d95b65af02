using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>The default detector of classes of several kinds: a part of a thing is not another thing.</summary>
public sealed class CombinedTargetDetectorTests
{
    private const double MetresPerPixel = 1.0 / 13;

    private static readonly (double, double, double) White = (236, 236, 232);
    private static readonly (double, double, double) Red = (205, 28, 32);
    private static readonly (double, double, double) Blue = (28, 72, 205);
    private static readonly (double, double, double) Glass = (30, 36, 42);

    private static readonly TargetClass Car = new("car")
    {
        Colour = new ColourRange(28, 72, 205),
        MinSideMetres = 2.3,
        MaxSideMetres = 3.6,
        MinAspect = 1.7,
        MaxAspect = 3.2,
        MinColourShare = 0.65,
    };

    private static readonly TargetClass Person = PersonIn(new ColourRange(205, 28, 32));

    private static readonly TargetClass Signal = new("signal")
    {
        Colour = new ColourRange(205, 28, 32),
        SecondColour = new ColourRange(236, 236, 232),
    };

    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Fact]
    public void Detect_PanelThatIsMostlyRed_IsThatPanelAndNoRedOne()
    {
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Signal];

        // Its red part is as large as a red panel.
        var painting = new Painting(5);
        painting.Rectangle(Red, 200, 150, 14, 10, 0);
        painting.Rectangle(White, 200, 157, 14, 4, 0);
        painting.Panel(DefaultTargetClasses.Red, 400, 300, 13, 0.2);
        byte[] picture = painting.Finish();

        Assert.Equal(["red", "red"], ClassesOf(Search(picture, TargetClass.Defaults, TargetClass.Defaults)));
        Assert.Equal(["red", "signal"], ClassesOf(Search(picture, classes, classes)));
        Assert.Equal(["signal"], ClassesOf(Search(picture, classes, [Signal])));
    }

    [Fact]
    public void Detect_CarOfThePanelsColour_IsACarAndThePanelAPanel()
    {
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Car];
        var painting = new Painting(6);
        painting.Rectangle(Blue, 200, 150, 4.4 / MetresPerPixel, 1.8 / MetresPerPixel, 0.3);
        painting.Rectangle(Glass, 200, 150, 0.6 / MetresPerPixel, 1.4 / MetresPerPixel, 0.3);
        painting.Panel(DefaultTargetClasses.Blue, 400, 300, 13, 0.2);

        Assert.Equal(["blue", "car"], ClassesOf(Search(painting.Finish(), classes, classes)));
    }

    [Fact]
    public void Detect_RoofOfACarOfThePanelsColour_IsAPartOfTheCar()
    {
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Car];
        var painting = new Painting(7);
        painting.Rectangle(Blue, 200, 150, 4.4 / MetresPerPixel, 1.8 / MetresPerPixel, 0.3);
        painting.Rectangle(Glass, 200, 150, 1.9 / MetresPerPixel, 1.5 / MetresPerPixel, 0.3);
        painting.Rectangle(Blue, 200, 150, 1.1 / MetresPerPixel, 1 / MetresPerPixel, 0.3);
        byte[] picture = painting.Finish();

        Assert.Equal(["car"], ClassesOf(Search(picture, classes, classes)));
    }

    [Fact]
    public void Detect_JacketOfThePanelsColour_IsThePersonAndThePanelAPanel()
    {
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Person];
        var painting = new Painting(9);
        painting.Rectangle(Red, 200, 150, 0.5 / MetresPerPixel, 0.6 / MetresPerPixel, 0);
        painting.Rectangle(Red, 200, 147.5, 0.75 / MetresPerPixel, 0.25 / MetresPerPixel, 0);   // the arms
        painting.Rectangle(Glass, 200, 159, 0.3 / MetresPerPixel, 0.8 / MetresPerPixel, 0);
        painting.Panel(DefaultTargetClasses.Red, 400, 300, 13, 0.2);
        byte[] picture = painting.Finish();

        Assert.Equal(["red", "red"], ClassesOf(Search(picture, TargetClass.Defaults, TargetClass.Defaults)));
        Assert.Equal(["person", "red"], ClassesOf(Search(picture, classes, classes)));
    }

    /// <summary>The same red square alone on grass is a panel, and with trousers beside it a jacket.</summary>
    [Theory]
    [InlineData(false, "red")]
    [InlineData(true, "person")]
    public void Detect_WhatMayBeAJacketOrAPanel_IsByWhatLiesBesideIt(bool hasTrousers, string expected)
    {
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, Person];
        foreach (double angle in new[] { 0, 0.4, 0.9, 2.5 })
        {
            var painting = new Painting(14);
            double side = 0.75 / MetresPerPixel;
            if (hasTrousers)
            {
                double down = side / 2 + (0.4 / MetresPerPixel);
                painting.Rectangle(
                    Glass, 200 - (down * Math.Sin(angle)), 150 + (down * Math.Cos(angle)), 0.45 / MetresPerPixel,
                    0.8 / MetresPerPixel, angle);
            }

            painting.Rectangle(Red, 200, 150, side, side, angle);
            Assert.Equal([expected], ClassesOf(Search(painting.Finish(), classes, classes)));
        }
    }

    [Theory]
    [InlineData(200, 1)]
    [InlineData(3, 0)]   // only the end of it is in the picture
    public void Detect_FormThatTheBorderCuts_IsLeftOut(double row, int count)
    {
        ImmutableArray<TargetClass> classes = [Car];
        var painting = new Painting(8);
        painting.Rectangle(Blue, 300, row, 4.4 / MetresPerPixel, 1.8 / MetresPerPixel, 0.1);
        byte[] picture = painting.Finish();

        Assert.Equal(count, Search(picture, classes, classes).Length);
        classes = [.. TargetClass.Defaults, Car];
        Assert.Equal(count, Search(picture, classes, classes).Length);
    }

    // Of the hue of the panel, as dry grass in warm light: the form takes some of it for a part of itself.
    [Fact]
    public void Detect_PanelOnGroundOfItsHue_IsThatPanelAndNoPerson()
    {
        TargetClass person = PersonIn(new ColourRange(243, 214, 28));
        ImmutableArray<TargetClass> classes = [.. TargetClass.Defaults, person];
        var painting = new Painting(11);
        painting.Rectangle((136, 118, 46), 211, 141, 10, 5, 0);
        painting.Panel(DefaultTargetClasses.Yellow, 200, 150, 13, 0, light: 0.75);
        byte[] picture = painting.Finish();

        Assert.Equal(["person"], ClassesOf(Search(picture, [person], [person])));
        Assert.Equal(["yellow"], ClassesOf(Search(picture, classes, classes)));
    }

    // The whole ground passes as yellow: the panel is not seen as one, and its blue half looks like a person.
    [Theory]
    [InlineData(0)]
    [InlineData(0.6)]
    [InlineData(1.5)]
    public void Detect_HalfOfAPanelOnGroundOfTheOtherHue_IsThatPanelAndNoPerson(double angle)
    {
        TargetClass person = PersonIn(new ColourRange(28, 72, 205));
        TargetClass panel = new("blue-yellow")
        {
            Colour = new ColourRange(28, 72, 205),
            SecondColour = new ColourRange(243, 214, 28),
        };
        var painting = new Painting(12);
        painting.Rectangle((93, 81, 30), 320, 240, Painting.Width, Painting.Height, 0);
        painting.TwoColours((16, 40, 110), (148, 121, 18), 200, 150, 13, angle, isChequered: false);
        painting.Rectangle((16, 40, 110), 400, 300, 13, 6.5, angle);   // what looks like it, and lies alone
        byte[] picture = painting.Finish();

        Assert.Equal(["person", "person"], ClassesOf(Search(picture, [person], [person])));
        TargetDetection[] both = Search(picture, [person, panel], [person, panel]);
        Assert.Equal(["blue-yellow", "person"], ClassesOf(both));
        TargetDetection found = both.Single(f => f.Class == panel.Name);
        Assert.Equal(200, found.CentreX, 1.0);
        Assert.Equal(150, found.CentreY, 1.0);
        Assert.Equal(1, found.SideMetres, 0.15);
        Assert.Equal(["person"], ClassesOf(Search(picture, [person, panel], [person])));
    }

    /// <summary>The other half of the panel is beyond the border, but for so many rows.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    public void Detect_HalfOfAPanelThatTheBorderCuts_IsNoPerson(int rows)
    {
        ImmutableArray<TargetClass> classes = [Signal, Person];
        foreach (bool isTop in new[] { true, false })
        {
            var painting = new Painting(10);
            double edge = isTop ? rows - 0.5 : Painting.Height - 0.5 - rows;
            double towards = isTop ? 1 : -1;
            painting.Rectangle(Red, 300, edge + (towards * 3.25), 13, 6.5, 0);
            painting.Rectangle(White, 300, edge - (towards * 3.25), 13, 6.5, 0);
            painting.Rectangle(Red, 300, 200, 13, 6.5, 0);   // what looks like it, and lies alone

            Assert.Equal(["person"], ClassesOf(Search(painting.Finish(), classes, classes)));
        }
    }

    /// <summary>
    /// Each form detector knows one white: of a white panel and a silver car both are found, the panel also on
    /// concrete, where the detector of panels sees one large thing.
    /// </summary>
    [Fact]
    public void Detect_WhitePanelBesideASilverCar_IsFound()
    {
        TargetClass white = new("white") { Colour = new ColourRange(236, 236, 232) };
        TargetClass silver = new("silver car")
        {
            Colour = new ColourRange(168, 172, 176),
            MinSideMetres = 2.3,
            MaxSideMetres = 3.6,
            MinAspect = 1.7,
            MaxAspect = 3.2,
            MinColourShare = 0.65,
        };
        var painting = new Painting(15);

        painting.Rectangle((165, 165, 153), 200, 150, 78, 62, 0.3);   // a slab of concrete
        painting.Rectangle((240, 240, 238), 200, 150, 13, 13, 0.3);
        painting.Rectangle((168, 172, 176), 450, 330, 4.4 / MetresPerPixel, 1.8 / MetresPerPixel, 0.3);
        byte[] picture = painting.Finish();

        Assert.Equal(["white"], ClassesOf(Search(picture, [white], [white])));
        Assert.Equal(["silver car", "white"], ClassesOf(Search(picture, [white, silver], [white, silver])));
    }

    /// <summary>Panels of two whites that differ are no fault: there is a detector for each.</summary>
    [Fact]
    public void Detect_PanelsOfTwoWhites_AreFound()
    {
        TargetClass Panel(string name, byte level, double side) => new(name)
        {
            Colour = new ColourRange(level, level, level),
            MinSideMetres = 0.8 * side,
            MaxSideMetres = 1.25 * side,
        };
        ImmutableArray<TargetClass> classes = [Panel("sheet", 240, 1), Panel("tarpaulin", 225, 2)];
        var painting = new Painting(16);
        painting.Rectangle(White, 200, 150, 13, 13, 0.3);
        painting.Rectangle((225, 225, 222), 400, 300, 26, 26, 0.3);

        Assert.Equal(["sheet", "tarpaulin"], ClassesOf(Search(painting.Finish(), classes, classes)));
    }

    [Fact]
    public void Constructor_TwoWhitesAmongTheForms_IsRefusedByName()
    {
        TargetClass Car(string name, byte level) => new(name)
        {
            Colour = new ColourRange(level, level, level),
            MinSideMetres = 2.3,
            MaxSideMetres = 3.6,
            MinColourShare = 0.65,
        };

        var options = new ImageProcessingOptions { TargetClasses = [Car("white car", 240), Car("silver car", 170)] };
        string text = Assert.Throws<InvalidOperationException>(() => options.CreateDetector()).Message;
        Assert.Contains("two whites or light greys", text, StringComparison.Ordinal);
        Assert.Contains("white car, silver car", text, StringComparison.Ordinal);
    }

    [Fact]
    public void MissionFile_MinColourShare_IsReadAndFoundByForm()
    {
        MissionPlan plan = MissionPlan.Parse(
            """
            {
              "area": [[47.0, 8.0], [47.001, 8.0], [47.001, 8.001]], "heightMetres": 40, "speedMetresPerSecond": 5,
              "laneSpacingMetres": 20,
              "targetClasses": { "car": { "colour": "#f0f0f0", "minColourShare": 0.65, "minSideMetres": 2.3,
                "maxSideMetres": 3.6, "minAspect": 1.7, "maxAspect": 3.2 } }
            }
            """,
            "field.json");
        TargetClass read = plan.TargetClasses.Single();
        Assert.Equal(0.65, read.MinColourShare);
        Assert.False(read.IsPanel || !read.IsForm);
        Assert.IsType<ShapeTargetDetector>(
            new ImageProcessingOptions { TargetClasses = plan.TargetClasses }.CreateDetector());
    }

    private TargetDetection[] Search(
        byte[] picture, ImmutableArray<TargetClass> declared, ImmutableArray<TargetClass> wanted)
    {
        ITargetDetector detector = new ImageProcessingOptions { TargetClasses = declared }.CreateDetector();
        var input = new DetectorInput(
            picture, Painting.Width, Painting.Height, wanted, PictureGroundScale.Uniform(MetresPerPixel));
        DetectorResult result = detector.Detect(input, _found);
        Assert.Null(result.Refusal);
        return _found.Take(result.Count).Where(f => !f.IsCut).ToArray();   // as Image Processing does
    }

    private static string[] ClassesOf(TargetDetection[] found)
        => [.. found.Select(f => f.Class.ToString()).OrderBy(n => n, StringComparer.Ordinal)];

    // By the colour of a jacket.
    private static TargetClass PersonIn(ColourRange colour) => new("person")
    {
        Colour = colour,
        MinSideMetres = 0.5,
        MaxSideMetres = 1.3,
        MinAspect = 1.3,
        MaxAspect = 4.5,
        MinColourShare = 0.35,
    };
}
