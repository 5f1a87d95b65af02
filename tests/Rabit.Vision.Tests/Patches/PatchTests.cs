using System;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests.Patches;

/// <summary>Finding and measuring patches, on painted pictures of 64 x 48.</summary>
public class PatchTests
{
    private const int Width = 64;
    private const int Height = 48;

    private static readonly PatchTable Table = new(
        [new ColourRange(205, 28, 32), new ColourRange(242, 112, 18), new ColourRange(236, 236, 234)]);

    private readonly PictureLight _light = new();
    private readonly PatchFinder _finder = new();
    private readonly PatchMeasure _measure = new();

    [Theory]
    [InlineData(205, 28, 32, 0)]
    [InlineData(110, 14, 17, 0)]
    [InlineData(242, 112, 18, 1)]
    [InlineData(255, 175, 40, 1)]   // overexposed: the hue turns towards yellow
    [InlineData(236, 236, 234, 2)]
    public void TryMeasure_Square_IsWhereAndWhatItIs(byte red, byte green, byte blue, int colour)
    {
        byte[] picture = Paint(red, green, blue, left: 20, top: 15, columns: 10, rows: 8);
        PatchShape shape = MeasureOnly(picture, colour);
        Assert.InRange(shape.CentreX, 24.4, 24.6);
        Assert.InRange(shape.CentreY, 18.4, 18.6);
        Assert.InRange(shape.Area, 79, 81);
        Assert.InRange(shape.MomentXX, 8, 8.5);
        Assert.InRange(shape.MomentYY, 5, 5.5);
        Assert.Equal((10, 8), ((int)shape.Width, (int)shape.Height));
        Assert.InRange(shape.Outline, 0.99, 1.01);
        Assert.InRange(shape.Continuation, 0, 0.01);
        Assert.False(shape.TouchesBorder);
        Assert.InRange(Table.CostOf(shape, colour, _light, out double mixed), 0, 4);
        Assert.InRange(mixed, 0, 0.2);
        Assert.InRange(Table.DarknessOf(shape, colour), 0, 1);
    }

    // Sand on one side counts as covered in part, and a dark bush hides the faded edge: without the slope of the
    // ground the centre is 0.27 and 0.47 pixels off.
    [Theory]
    [InlineData(150, 120, 100)]
    [InlineData(30, 45, 28)]
    public void CorrectCentre_OtherGroundOnOneSide_CentreHardlyMoves(byte r, byte g, byte b)
    {
        byte[] picture = Paint(205, 28, 32, left: 0, top: 0, columns: 0, rows: 0);
        Paint(picture, r, g, b, left: 0, top: 0, columns: 24, rows: Height);
        Paint(picture, 205, 28, 32, left: 20, top: 15, columns: 8, rows: 8);
        Find(Blur(Blur(picture)));
        Patch[] red = [.. _finder.Patches.ToArray().Where(p => p.Colour == 0 && !p.IsStrong)];
        Assert.True(_measure.TryLook(red, out PatchShape shape) && _measure.TryMeasure(ref shape));
        _measure.CorrectCentre(ref shape);
        Assert.InRange(shape.CentreX, 23.27, 23.73);
        Assert.InRange(shape.CentreY, 18.43, 18.57);
    }

    [Fact]
    public void TryMeasure_AtTheBorder_SaysHowMuchOfItTheBorderCuts()
    {
        PatchShape shape = MeasureOnly(Paint(205, 28, 32, left: 0, top: 15, columns: 6, rows: 8), 0);
        Assert.True(shape.TouchesBorder);
        Assert.Equal(8, shape.CutLength);
    }

    [Theory]
    [InlineData(242, 112, 18, 1)]
    [InlineData(205, 28, 32, 0)]
    public void CostOf_InHaze_IsThatWithoutIt(byte red, byte green, byte blue, int colour)
    {
        byte[] picture = Paint(red, green, blue, left: 20, top: 15, columns: 10, rows: 8);
        Paint(picture, 8, 10, 7, left: 40, top: 30, columns: 20, rows: 10);
        double clear = Table.CostOf(MeasureOnly(picture, colour), colour, _light, out _);
        Assert.InRange(_light.GreenVeil, 0, 0.002);
        for (int at = 0; at < picture.Length; at++)
            picture[at] = (byte)LinearLight.ToLevel(LinearLight.Of(picture[at]) + 0.045);
        PatchShape shape = MeasureOnly(picture, colour);
        Assert.InRange(_light.GreenVeil, 0.02, 0.03);
        double hazy = Table.CostOf(shape, colour, _light, out _);
        _light.Measure(Paint(0, 0, 0, left: 0, top: 0, columns: Width, rows: Height), Width, Height);
        Assert.Equal(0, _light.GreenVeil);
        Assert.InRange(hazy, clear, 0.5 * Table.CostOf(shape, colour, _light, out _));
    }

    [Fact]
    public void TryLook_BlurredEdge_ColourIsThatOfTheMiddle()
    {
        byte[] picture = Paint(150, 60, 50, left: 20, top: 15, columns: 8, rows: 8);
        Paint(picture, 180, 40, 40, left: 21, top: 16, columns: 6, rows: 6);
        Paint(picture, 205, 28, 32, left: 22, top: 17, columns: 4, rows: 4);
        PatchShape shape = MeasureOnly(picture, 0);
        Assert.Equal((205, 28, 32), ((int)shape.Red, (int)shape.Green, (int)shape.Blue));
    }

    [Fact]
    public void TryMeasure_PartsWithAGap_AreOneThing()
    {
        byte[] picture = Paint(205, 28, 32, left: 20, top: 15, columns: 6, rows: 8);
        Paint(picture, 205, 28, 32, left: 28, top: 15, columns: 6, rows: 8);
        Find(picture);
        Patch[] patches = [.. _finder.Patches.ToArray().Where(p => !p.IsStrong)];
        Assert.Equal(2, patches.Length);
        Assert.True(_measure.TryLook(patches, out PatchShape shape) && _measure.TryMeasure(ref shape));
        Assert.InRange(shape.CentreX, 26.4, 26.6);
        Assert.InRange(shape.Area, 111, 113);
    }

    [Fact]
    public void Measure_BlueLight_IsUndone()
    {
        byte[] picture = Paint(205, 28, 32, left: 20, top: 15, columns: 10, rows: 8);
        for (int at = 0; at < picture.Length; at += 3)
            picture[at + 2] = (byte)Math.Min(255, picture[at + 2] * 3);
        _light.Measure(picture, Width, Height);
        Assert.InRange(_light.BlueGain, 0.5, 0.8);
        Assert.InRange(_light.RedGain, 0.95, 1.05);
    }

    [Fact]
    public void Measure_RedSoil_IsNoRedLight()
    {
        byte[] picture = Paint(165, 97, 60, left: 0, top: 0, columns: Width, rows: Height);
        _light.Measure(picture, Width, Height);
        Assert.InRange(_light.RedGain, 0.85, 1);
        Assert.True(243 * _light.RedGain > 0.9 * 214);   // still yellow
    }

    [Fact]
    public void TryFind_WhiteAtPaleConcrete_IsAPatchOfItsOwn()
    {
        byte[] picture = Paint(240, 240, 238, left: 40, top: 18, columns: 8, rows: 6);
        Paint(picture, 185, 185, 180, left: 25, top: 19, columns: 3, rows: 4);
        Paint(picture, 240, 240, 238, left: 28, top: 19, columns: 2, rows: 4);
        Find(picture);
        Patch white = Assert.Single(_finder.Patches.ToArray(), p => p.IsStrong);
        Assert.Equal((28, 29, 19, 22), (white.Left, white.Right, white.Top, white.Bottom));
        Assert.Contains(_finder.Patches.ToArray(), p => !p.IsStrong && p.Left == 25 && p.Right == 29);
    }

    [Fact]
    public void TryFind_PictureAfterPicture_AllocatesNothing()
    {
        byte[] picture = Paint(205, 28, 32, left: 20, top: 15, columns: 10, rows: 8);
        MeasureOnly(picture, 0);
        Patch[] first = [_finder.Patches[0]];
        Assert.Equal(0, Allocated.By(() =>
        {
            Find(picture);
            _measure.TryLook(first, out PatchShape shape);
            _measure.TryMeasure(ref shape);
            _measure.CorrectCentre(ref shape);
        }));
    }

    [Theory]
    [InlineData(236, 236, 234, true)]
    [InlineData(168, 172, 176, false)]   // a silver car: what is white beside it does not make it grey
    [InlineData(20, 20, 20, false)]
    [InlineData(205, 28, 32, false)]
    public void IsWhite_Colour_IsOfWhiteAlone(byte red, byte green, byte blue, bool isWhite)
        => Assert.Equal(isWhite, new PatchTable([new ColourRange(red, green, blue)]).IsWhite(0));

    // The silver of a car on dry grass, less bright than white is.
    [Fact]
    public void CostOf_LightGrey_IsByItsOwnBrightness()
    {
        var silver = new PatchTable([new ColourRange(168, 172, 176)]);
        byte[] picture = new byte[Width * Height * 3];
        Paint(picture, 124, 121, 90, 0, 0, Width, Height);
        Paint(picture, 168, 176, 177, left: 20, top: 15, columns: 12, rows: 10);
        _light.Measure(picture, Width, Height);
        Assert.True(_finder.TryFind(picture, Width, Height, silver, _light));
        _measure.SetPicture(picture, Width, Height, _finder, _light);
        Assert.True(_measure.TryLook(_finder.Patches, out PatchShape shape));
        Assert.InRange(silver.CostOf(shape, 0, _light, out _), 0, 1);
    }

    /// <summary>A light grey with a tint of its own is not untinted.</summary>
    [Theory]
    [InlineData(150, 160, 185, 0, 0.5)]
    [InlineData(165, 165, 165, 3, 10)]
    public void CostOf_TintedGrey_IsByItsOwnTint(byte red, byte green, byte blue, double min, double max)
    {
        var grey = new PatchTable([new ColourRange(150, 160, 185)]);
        _light.Measure(Paint(86, 112, 70, 0, 0, 1, 1), Width, Height);
        PatchShape shape = ShapeOf((red, green, blue), (86, 112, 70));

        Assert.InRange(grey.CostOf(shape, 0, _light, out _), min, max);
    }

    [Theory]
    [InlineData(236, 236, 234, 1, 1)]
    [InlineData(220, 220, 220, 1, 1)]   // a white that is not so bright
    [InlineData(168, 172, 176, 0.45, 0.48)]
    [InlineData(130, 130, 130, 0.4, 0.4)]
    [InlineData(20, 20, 20, 1, 1)]
    [InlineData(205, 28, 32, 1, 1)]
    public void PartOfWhite_Colour_IsLessForALightGrey(byte red, byte green, byte blue, double min, double max)
        => Assert.InRange(new PatchTable([new ColourRange(red, green, blue)]).PartOfWhite(0), min, max);

    // Of a warm white, on usual ground and on ground so dark that a stone would be as bright: what it is brighter by
    // counts up to a limit.
    [Theory]
    [InlineData(112, 3.2, 3.4)]
    [InlineData(76, 2.7, 2.9)]
    [InlineData(30, 2.7, 2.9)]
    public void CostOf_WarmWhite_IsTheLessTheBrighterItIs(byte ground, double min, double max)
    {
        byte[] picture = new byte[Width * Height * 3];
        Paint(picture, ground, ground, ground, 0, 0, Width, Height);
        _light.Measure(picture, Width, Height);

        Assert.InRange(
            Table.CostOf(ShapeOf((250, 236, 215), (ground, ground, ground)), 2, _light, out _), min, max);
    }

    // On lush grass blue is raised, and may be so too much: the white and that with less blue are both white.
    [Theory]
    [InlineData(240, 240, 238, 0, 0.6)]
    [InlineData(240, 240, 214, 0, 0.6)]
    [InlineData(240, 240, 180, 4, 20)]
    public void CostOf_WhiteOnLushGrass_IsByTheLikelierTint(byte red, byte green, byte blue, double min, double max)
    {
        byte[] picture = new byte[Width * Height * 3];
        Paint(picture, 86, 112, 55, 0, 0, Width, Height);
        _light.Measure(picture, Width, Height);
        double raised = blue * _light.BlueGain;

        Assert.InRange(_light.BlueGain, 1.11, 1.13);
        Assert.InRange(
            Table.CostOf(ShapeOf((red, green, raised), (86, 112, 62)), 2, _light, out _), min, max);
    }

    // Up to 2.4 with which white is found: a tint of 6 % in red and blue is light, 15 % are a colour, and what is warm
    // with less green is concrete.
    [Theory]
    [InlineData(236, 236, 234, 0, 0.1)]
    [InlineData(250, 236, 221, 0.5, 2.4)]
    [InlineData(224, 236, 250, 0.5, 2.4)]
    [InlineData(250, 217, 184, 7, 20)]
    [InlineData(236, 236, 224, 0.3, 1.5)]
    [InlineData(244, 219, 221, 4, 10)]
    public void CostOf_White_IsByWhatLightMayDoToIt(byte red, byte green, byte blue, double min, double max)
    {
        byte[] picture = Paint(red, green, blue, left: 20, top: 15, columns: 10, rows: 8);
        _light.Measure(picture, Width, Height);

        Assert.InRange(Table.CostOf(ShapeOf((red, green, blue), (86, 112, 70)), 2, _light, out _), min, max);
    }

    // Red soil is no red light: what its tint says of the light is limited.
    [Theory]
    [InlineData(86, 112, 70, 0, 0.005)]
    [InlineData(120, 120, 75, 0.025, 0.03)]
    [InlineData(200, 100, 55, 0.06, 0.06)]
    [InlineData(60, 120, 120, -0.05, -0.045)]
    public void LikelyTint_Ground_IsATenthOfItsOwnUpToALimit(
        byte red, byte green, byte blue, double min, double max)
    {
        byte[] picture = new byte[Width * Height * 3];
        Paint(picture, red, green, blue, 0, 0, Width, Height);
        _light.Measure(picture, Width, Height);

        Assert.InRange(_light.LikelyTint, min, max);
    }

    /// <summary>
    /// What fills one or two tiles, of 8 x 6 pixels here, as a car seen from low above, does not make the ground there
    /// brighter; a road through three does.
    /// </summary>
    [Theory]
    [InlineData(16, 12, 8, 6, 112)]
    [InlineData(16, 12, 16, 6, 112)]
    [InlineData(0, 0, 16, 6, 112)]   // in the corner
    [InlineData(24, 0, 16, 6, 112)]   // at the edge
    [InlineData(16, 0, 8, 48, 150)]
    public void LevelAt_BrightThing_IsThatOfTheGroundAroundWhereItFillsTwoTiles(
        int left, int top, int columns, int rows, int expected)
    {
        _light.Measure(Paint(150, 150, 150, left, top, columns, rows), Width, Height);

        Assert.Equal(expected, _light.LevelAt(left + 2, top + (rows / 2)));
        Assert.Equal(95, _light.LevelAt(Width - 2, Height - 2));
    }

    /// <summary>Where all around is in deep shade, a tile may be as bright as the picture.</summary>
    [Fact]
    public void LevelAt_TileAmongBlackOnes_IsNoDarkerThanThePicture()
    {
        byte[] picture = Paint(0, 0, 0, 8, 6, 24, 18);
        Paint(picture, 86, 112, 70, 16, 12, 8, 6);
        _light.Measure(picture, Width, Height);

        Assert.Equal(95, _light.LevelAt(18, 14));
    }

    [Fact]
    public void New_WhiteTwice_IsRefused()
        => Assert.Throws<ArgumentException>(
            () => new PatchTable([new ColourRange(236, 236, 234), new ColourRange(250, 250, 250)]));

    private static PatchShape ShapeOf(
        (double Red, double Green, double Blue) colour, (double Red, double Green, double Blue) ground) => new()
        {
            Red = colour.Red,
            Green = colour.Green,
            Blue = colour.Blue,
            GroundRed = ground.Red,
            GroundGreen = ground.Green,
            GroundBlue = ground.Blue,
            Area = 80,
        };

    private static byte[] Paint(byte red, byte green, byte blue, int left, int top, int columns, int rows)
    {
        byte[] picture = new byte[Width * Height * 3];
        Paint(picture, 86, 112, 70, 0, 0, Width, Height);
        Paint(picture, red, green, blue, left, top, columns, rows);
        return picture;
    }

    private static void Paint(
        byte[] picture, byte red, byte green, byte blue, int left, int top, int columns, int rows)
    {
        for (int pixel = 0; pixel < columns * rows; pixel++)
        {
            int at = (((top + (pixel / columns)) * Width) + left + (pixel % columns)) * 3;
            (picture[at], picture[at + 1], picture[at + 2]) = (red, green, blue);
        }
    }

    // Each pixel the mean of three by three.
    private static byte[] Blur(byte[] picture)
    {
        byte[] blurred = new byte[picture.Length];
        for (int at = 0; at < picture.Length; at++)
        {
            (int row, int column) = (at / (3 * Width), at / 3 % Width);
            int sum = 0;
            for (int i = 0; i < 9; i++)
            {
                int otherRow = Math.Min(Height - 1, Math.Max(0, row + (i / 3) - 1));
                int otherColumn = Math.Min(Width - 1, Math.Max(0, column + (i % 3) - 1));
                sum += picture[(((otherRow * Width) + otherColumn) * 3) + (at % 3)];
            }

            blurred[at] = (byte)(sum / 9);
        }

        return blurred;
    }

    private void Find(byte[] picture)
    {
        _light.Measure(picture, Width, Height);
        Assert.True(_finder.TryFind(picture, Width, Height, Table, _light));
        _measure.SetPicture(picture, Width, Height, _finder, _light);
    }

    private PatchShape MeasureOnly(byte[] picture, int colour)
    {
        Find(picture);
        Assert.NotEqual(0, _finder.Count);
        Assert.All(_finder.Patches.ToArray(), p => Assert.Equal(colour, p.Colour));
        Assert.True(_measure.TryLook(_finder.Patches.Slice(0, 1), out PatchShape shape));
        Assert.True(_measure.TryMeasure(ref shape));
        _measure.CorrectCentre(ref shape);
        return shape;
    }
}
