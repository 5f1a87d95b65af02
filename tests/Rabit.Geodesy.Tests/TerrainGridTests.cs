using System;
using System.IO;
using Xunit;

namespace Rabit.Geodesy.Tests;

public sealed class TerrainGridTests
{
    private const string Small =
        "ncols 3\nnrows 2\nxllcenter 8\nyllcenter 47\ncellsize 0.01\nNODATA_value -1\n10 20 30\n40 50 -1\n";

    [Fact]
    public void Read_TextGrid_HasRowsFromTheNorthAndHolesWhereThereIsNoData()
    {
        TerrainGrid grid = AsciiGrid.Read(new StringReader(Small));
        Assert.Equal(50, grid.MaxAltitude.Metres);
        Assert.Equal(40, Height(grid, 47, 8));
        Assert.Equal(10, Height(grid, 47.01, 8), 1e-6);
        Assert.Equal(30, Height(grid, 47.005, 8.005), 1e-6);
        Assert.Equal(TerrainLookup.NoData, grid.TryAltitude(Point(47.002, 8.015), out _));
        Assert.Equal(TerrainLookup.Outside, grid.TryAltitude(Point(46.999, 8.01), out _));
        Assert.Equal(TerrainLookup.Outside, grid.TryAltitude(Point(double.NaN, 8.01), out _));
        Assert.Equal(
            40, Height(AsciiGrid.Read(new StringReader(Small.Replace("xllcenter 8", "XLLCORNER 7.995"))), 47, 8), 1e-6);
    }

    [Theory]
    [InlineData("ncols 3", "ncols 4", "ends after 6")]
    [InlineData("ncols 3", "ncols 2", "more than")]
    [InlineData("ncols 3", "ncols x", "'x' is not a number")]
    [InlineData("ncols 3\n", "", "does not give its ncols")]
    [InlineData("cellsize 0.01\n", "", "cellsize")]
    [InlineData("yllcenter 47", "yllcenter 91", "not on the earth")]
    [InlineData("xllcenter 8", "xllcenter 465005", "The grid begins at 465005, 47, which are no degrees")]
    [InlineData("10 20 30", "10 q 30", "Line 7 of the grid: 'q'")]
    [InlineData("nrows 2", "nrows 1", "nrows is 1")]
    public void Read_BadGrid_SaysWhere(string old, string other, string text)
    {
        string bad = Small.Replace(old, other);
        Assert.Contains(
            text, Assert.Throws<FormatException>(() => AsciiGrid.Read(new StringReader(bad))).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void ReadEllipsoidHeights_WithAGeoid_ComeAboveMeanSeaLevel()
    {
        GeoidGrid geoid = GeoidGridTests.Grid((row, column) => 47.5);
        TerrainGrid grid = AsciiGrid.ReadEllipsoidHeights(new StringReader(Small), geoid);
        Assert.Equal(2.5, grid.MaxAltitude.Metres, 1e-3);
        Assert.Equal(-7.5, Height(grid, 47, 8), 1e-3);
        Assert.Equal(TerrainLookup.NoData, grid.TryAltitude(Point(47.002, 8.015), out _));
    }

    [Theory]
    [InlineData(47.0005, 8.001, 47.001, 8.002, TerrainLookup.Known, 50)]
    [InlineData(47.0005, 8.001, 47.0005, 8.001, TerrainLookup.Known, 50)]
    [InlineData(47, 8, 47.01, 8.0099, TerrainLookup.Known, 50)]
    [InlineData(47.001, 8.001, 47.002, 8.012, TerrainLookup.NoData, double.NaN)]
    [InlineData(46.99, 8.001, 47.001, 8.002, TerrainLookup.Outside, double.NaN)]
    [InlineData(47.001, 8.002, 47.0005, 8.001, TerrainLookup.Outside, double.NaN)]
    public void TryMaxAltitude_Box_IsTheHighestPostOfItsCells(
        double south, double west, double north, double east, TerrainLookup expected, double metres)
    {
        TerrainGrid grid = AsciiGrid.Read(new StringReader(Small));
        Assert.Equal(
            expected, grid.TryMaxAltitude(Point(south, west), Point(north, east), out AmslAltitude altitude));
        Assert.Equal(metres, altitude.Metres);
        Assert.Equal((0.01, 0.01), (grid.LatitudeStep.Degrees, grid.LongitudeStep.Degrees));
    }

    private static double Height(TerrainGrid grid, double latitude, double longitude)
    {
        Assert.Equal(TerrainLookup.Known, grid.TryAltitude(Point(latitude, longitude), out AmslAltitude altitude));
        return altitude.Metres;
    }

    private static GeographicPoint Point(double latitude, double longitude)
        => new(Angle.FromDegrees(latitude), Angle.FromDegrees(longitude));
}
