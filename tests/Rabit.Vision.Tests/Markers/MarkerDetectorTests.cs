using System;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Markers;

public sealed class MarkerDetectorTests(ITestOutputHelper output)
{
    private const int Size = 120;

    [Fact, Trait("Category", "Long")]
    public void Find_EveryIdOfTheLargerFamily_IsReadWithItsCornersInOrder()
        => Find_Ids_AreReadWithTheirCornersInOrder(MarkerFamily.AprilTag36h11, 587, step: 1);

    [Theory]
    [InlineData(MarkerFamily.ArUco4x4, 50, 1)]
    [InlineData(MarkerFamily.AprilTag36h11, 587, 7)]
    public void Find_Ids_AreReadWithTheirCornersInOrder(MarkerFamily family, int ids, int step)
    {
        MarkerDictionary dictionary = MarkerDictionary.Of(family);
        Assert.Equal(ids, dictionary.Count);
        var detector = new MarkerDetector();
        for (int id = 0; id < ids; id += step)
        {
            // All quarters; not along the pixels, where samples of the drawing make steps.
            double angle = 0.15 + (id % 4 * Math.PI / 2) + (id % 10 * 0.12);
            DetectedMarker marker = Assert.Single(
                detector.Find(DrawnMarker.Draw(Size, dictionary, id, 60, angle), Size, Size).ToArray());
            Assert.Equal((family, id, 0), (marker.Family, marker.Id, marker.CorrectedBits));
            AssertCorners(marker, 60, angle, 0.2);
            Assert.InRange(marker.Margin, 0.95, 1);
            Assert.InRange(marker.Contrast, 185, 192);
        }
    }

    [Theory]
    [InlineData(MarkerFamily.ArUco4x4, 15)]
    [InlineData(MarkerFamily.AprilTag36h11, 20)]
    public void Find_SmallMarker_IsRead(MarkerFamily family, double side)
    {
        MarkerDictionary dictionary = MarkerDictionary.Of(family);
        var detector = new MarkerDetector();
        int found = 0;
        for (int id = 0; id < 50; id++)
        {
            double angle = id * 0.13;
            ReadOnlySpan<DetectedMarker> markers =
                detector.Find(DrawnMarker.Draw(64, dictionary, id, side, angle), 64, 64);
            foreach (DetectedMarker marker in markers)
            {
                Assert.Equal((family, id), (marker.Family, marker.Id));
                found++;
            }
        }

        output.WriteLine($"{family}, side {side}: {found} of 50");
        Assert.True(found >= 45, $"{found} of 50");
    }

    [Fact]
    public void Find_LargeMarker_IsRead()
    {
        var detector = new MarkerDetector();
        byte[] grey = DrawnMarker.Draw(600, MarkerDictionary.ArUco4x4, 7, 350, 0.3);
        DetectedMarker marker = Assert.Single(detector.Find(grey, 600, 600).ToArray());
        Assert.Equal(7, marker.Id);
        AssertCorners(marker, 350, 0.3, 0.05, 600);
    }

    // Not of 4 x 4: the mirror image of its id 17 is itself, and others may be alike.
    [Fact]
    public void Find_MirrorImage_IsNoMarker()
    {
        var detector = new MarkerDetector();
        for (int id = 0; id < 100; id++)
        {
            byte[] grey = DrawnMarker.Draw(Size, MarkerDictionary.AprilTag36h11, id, 60, 0.2, isMirrored: true);
            Assert.True(detector.Find(grey, Size, Size).IsEmpty, $"id {id}");
        }
    }

    [Fact]
    public void Find_NoWhiteAroundIt_IsNoMarker()
    {
        byte[] grey = DrawnMarker.Draw(
            Size, MarkerDictionary.AprilTag36h11, 3, 60, 0.2, quietCells: 0, ground: DrawnMarker.Black);
        Assert.True(new MarkerDetector().Find(grey, Size, Size).IsEmpty);
    }

    [Fact]
    public void Find_OtherFamily_IsNotRead()
    {
        var detector = new MarkerDetector(new MarkerDetectorOptions { Families = [MarkerFamily.ArUco4x4] });
        byte[] grey = DrawnMarker.Draw(Size, MarkerDictionary.AprilTag36h11, 3, 60, 0.2);
        Assert.True(detector.Find(grey, Size, Size).IsEmpty);
    }

    [Fact]
    public void Find_NoiseAndClutter_HasNoId() => FindNothing(seed: 20, count: 200);

    // Picture 31 has squares in squares that read as id 10 to the last cell, with cells of 3 pixels.
    [Fact]
    public void Find_SquaresInSquaresLikeASimpleCode_HasNoId() => FindNothing(seed: 122, count: 32);

    [Theory]
    [InlineData(3.2, 0)]
    [InlineData(4.6, 1)]
    public void Find_SimpleCode_IsReadWhereItsCellsAreLarge(double cellPixels, int found)
    {
        MarkerDictionary dictionary = MarkerDictionary.ArUco4x4;
        int[] simple = [.. Enumerable.Range(0, dictionary.Count).Where(dictionary.IsSimple)];
        Assert.Equal([10, 17, 34, 37], simple);
        var detector = new MarkerDetector();
        foreach (int id in simple)
        {
            byte[] grey = DrawnMarker.Draw(Size, dictionary, id, dictionary.Cells * cellPixels, 0.3);
            Assert.Equal(found, detector.Find(grey, Size, Size).Length);
        }

        // One that no two rectangles look like.
        byte[] other = DrawnMarker.Draw(Size, dictionary, 13, dictionary.Cells * cellPixels, 0.3);
        Assert.Equal(13, Assert.Single(detector.Find(other, Size, Size).ToArray()).Id);
    }

    [Fact]
    public void IsSimple_LargerFamily_NoneIs()
        => Assert.DoesNotContain(
            Enumerable.Range(0, MarkerDictionary.AprilTag36h11.Count), MarkerDictionary.AprilTag36h11.IsSimple);

    [Theory, Trait("Category", "Long")]
    [InlineData(21)]
    [InlineData(22)]
    public void Find_MuchNoiseAndClutter_HasNoId(int seed) => FindNothing(seed, count: 10_000);

    [Fact]
    public void Find_PictureAgain_AllocatesNothing()
    {
        if (!Allocated.IsSupported)
            return;
        var detector = new MarkerDetector();
        byte[] marker = DrawnMarker.Draw(Size, MarkerDictionary.AprilTag36h11, 3, 60, 0.2);
        byte[] clutter = new ClutterPictures(1, 320, 240).Next(7);
        int found = 0;
        void Work()
            => found = detector.Find(marker, Size, Size).Length + detector.Find(clutter, 320, 240).Length;

        Work();
        Assert.Equal(0, Allocated.By(Work));
        Assert.Equal(1, found);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(9, 300)]
    [InlineData(300, 9)]
    [InlineData(33, 31)]
    public void Find_AnySize_Searches(int width, int height)
    {
        byte[] grey = new byte[width * height];
        new Random(3).NextBytes(grey);
        Assert.True(new MarkerDetector().Find(grey, width, height).IsEmpty);
    }

    [Theory]
    [InlineData(0, 5)]
    [InlineData(5, 0)]
    [InlineData(5, 6)]
    [InlineData(-5, -5)]
    public void Find_BufferTooSmall_Throws(int width, int height)
        => Assert.Contains(
            $"{width} x {height}",
            Assert.Throws<ArgumentException>(() => new MarkerDetector().Find(new byte[25], width, height)).Message,
            StringComparison.Ordinal);

    [Fact]
    public void Constructor_OptionsOutOfRange_NamesAll()
    {
        var options = new MarkerDetectorOptions { Families = [], MinSidePixels = 2, MinContrast = 0 };
        string message = Assert.Throws<ArgumentException>(() => new MarkerDetector(options)).Message;
        foreach (string name in new[] { "Families", "MinSidePixels", "MinContrast" })
            Assert.Contains(name, message, StringComparison.Ordinal);
        Assert.Contains("family 9", Assert.Throws<ArgumentException>(() => new MarkerDetector(
            new MarkerDetectorOptions { Families = [(MarkerFamily)9] })).Message, StringComparison.Ordinal);
    }

    private static void AssertCorners(DetectedMarker marker, double side, double angle, double limit, int size = Size)
    {
        for (int corner = 0; corner < 4; corner++)
        {
            PicturePoint expected = DrawnMarker.Corner(size, side, angle, corner);
            double off = marker.Corners[corner].DistanceTo(expected);
            Assert.True(off < limit, $"id {marker.Id}, corner {corner}: {off} px off");
        }
    }

    private void FindNothing(int seed, int count)
    {
        var clutter = new ClutterPictures(seed, 320, 240);
        var detector = new MarkerDetector();
        for (int number = 0; number < count; number++)
        {
            foreach (DetectedMarker marker in detector.Find(clutter.Next(number), 320, 240))
                Assert.Fail($"seed {seed}, picture {number}: {marker.Family} {marker.Id} at {marker.Corners}");
        }

        output.WriteLine($"seed {seed}: {count} pictures without an id");
    }
}
