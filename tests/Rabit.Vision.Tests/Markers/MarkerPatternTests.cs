using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Markers;

/// <summary>The patterns to print: the detector reads each of them.</summary>
public sealed class MarkerPatternTests
{
    private const int Side = 120;
    private const int CellPixels = 9;
    private const int Margin = 2 * CellPixels;

    [Theory]
    [InlineData(MarkerFamily.ArUco4x4, 50, 6)]
    [InlineData(MarkerFamily.AprilTag36h11, 587, 8)]
    public void IsWhite_EveryMarkerDrawn_IsFoundWithItsIdUpright(MarkerFamily family, int count, int cells)
    {
        Assert.Equal(count, MarkerPattern.Count(family));
        Assert.Equal(cells, MarkerPattern.CellsPerSide(family));
        var detector = new MarkerDetector(new MarkerDetectorOptions { Families = [family] });
        for (int id = 0; id < count; id++)
        {
            DetectedMarker marker = Assert.Single(detector.Find(Draw(family, id), Side, Side).ToArray());

            Assert.Equal(id, marker.Id);
            Assert.Equal(Margin - 0.5, marker.Corners.TopLeft.X, 0.3);
            Assert.Equal(Margin - 0.5, marker.Corners.TopLeft.Y, 0.3);
            Assert.Equal(Margin + (cells * CellPixels) - 0.5, marker.Corners.TopRight.X, 0.3);
        }
    }

    [Theory]
    [InlineData(MarkerFamily.ArUco4x4, -1)]
    [InlineData(MarkerFamily.ArUco4x4, 50)]
    [InlineData(MarkerFamily.AprilTag36h11, 587)]
    [InlineData((MarkerFamily)7, 0)]
    public void IsWhite_NoSuchMarker_IsRefusedByName(MarkerFamily family, int id)
    {
        ArgumentOutOfRangeException refused =
            Assert.Throws<ArgumentOutOfRangeException>(() => MarkerPattern.IsWhite(family, id, 1, 1));
        Assert.Contains(family == (MarkerFamily)7 ? "no such family" : "has the ids 0 to", refused.Message);
    }

    private static byte[] Draw(MarkerFamily family, int id)
    {
        byte[] grey = new byte[Side * Side];
        for (int i = 0; i < grey.Length; i++)
        {
            int row = (int)Math.Floor(((i / Side) - Margin) / (double)CellPixels);
            int column = (int)Math.Floor(((i % Side) - Margin) / (double)CellPixels);
            grey[i] = MarkerPattern.IsWhite(family, id, row, column) ? (byte)220 : (byte)30;
        }

        return grey;
    }
}
