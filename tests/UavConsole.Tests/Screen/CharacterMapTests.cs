using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting.Tests;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The map of the screen: pure, from model to lines.</summary>
public sealed class CharacterMapTests
{
    private static readonly MapModel Square = new()
    {
        Area = [new(0, 0, 0), new(100, 0, 0), new(100, 100, 0), new(0, 100, 0)],
        Home = new NedPosition(-10, -10, 0),
    };

    [Theory]
    [InlineData(44, 13)]
    [InlineData(1, 1)]
    [InlineData(110, 40)]
    public void Draw_AnySize_IsAsLargeAsAskedFor(int columns, int rows)
    {
        MapPicture map = CharacterMap.Draw(MapModel.Of(MadeUpFlight.Record()), columns, rows);

        Assert.Equal(rows, map.Lines.Count);
        Assert.All(map.Lines, l => Assert.Equal(columns, l.Length));
    }

    [Fact]
    public void Draw_NorthIsUpAndEastIsRight()
    {
        MapPicture map = CharacterMap.Draw(
            new MapModel
            {
                Area = Square.Area,
                Home = Square.Home,
                Tracks = [Track(DefaultTargetClasses.Red, 90, 10), Track(DefaultTargetClasses.Blue, 10, 90)],
                Vehicle = new NedPosition(50, 50, -40),
                VehicleYawRadians = Math.PI / 2,
            },
            40,
            20);
        (int redColumn, int redRow) = Find(map, 'R');
        (int blueColumn, int blueRow) = Find(map, 'B');
        (int homeColumn, int homeRow) = Find(map, 'H');
        (int vehicleColumn, int vehicleRow) = Find(map, '→');

        Assert.True(redRow < vehicleRow && vehicleRow < blueRow && blueRow <= homeRow, string.Join("\n", map.Lines));
        Assert.True(
            homeColumn < redColumn && redColumn < vehicleColumn && vehicleColumn < blueColumn,
            string.Join("\n", map.Lines));
        Assert.Equal(
            (MapInk.Red, MapInk.Vehicle), (map.InkAt(redColumn, redRow), map.InkAt(vehicleColumn, vehicleRow)));
    }

    [Theory]
    [InlineData(0, '↑')]
    [InlineData(44, '↗')]
    [InlineData(181, '↓')]
    [InlineData(-90, '←')]
    [InlineData(359, '↑')]
    [InlineData(double.NaN, '+')]
    public void Draw_Vehicle_PointsWhereItHeads(double degrees, char arrow)
    {
        MapPicture map = CharacterMap.Draw(
            new MapModel { Vehicle = default(NedPosition), VehicleYawRadians = degrees * Angle.RadiansPerDegree }, 9,
            5);

        Assert.Contains(map.Lines, l => l.Contains(arrow));
    }

    [Fact]
    public void Draw_TrackStates_AreShown()
    {
        MapPicture map = CharacterMap.Draw(
            new MapModel
            {
                Area = Square.Area,
                Tracks =
                [
                    Track(DefaultTargetClasses.Yellow, 20, 20, TrackState.Tentative),
                    Track(DefaultTargetClasses.Magenta, 50, 50),
                    Track(DefaultTargetClasses.Red, 80, 80, TrackState.Lost)
                ],
            },
            40,
            20);

        foreach (char mark in "?Mx")
            Assert.Contains(map.Lines, l => l.Contains(mark));
        Assert.DoesNotContain(map.Lines, l => l.Contains('Y'));
    }

    [Fact]
    public void Draw_Ellipse_IsShownOnceItIsLargerThanACharacter()
    {
        int Inked(double variance) => Ink(CharacterMap.Draw(
            new MapModel
            {
                Area = Square.Area,
                Tracks = [Track(DefaultTargetClasses.Red, 50, 50, TrackState.Confirmed, variance)]
            },
            40, 20),
                MapInk.Ellipse);

        Assert.Equal(0, Inked(0.5));
        Assert.InRange(Inked(50), 6, 60);
    }

    [Fact]
    public void Draw_WithoutUnicode_IsPlainAscii()
    {
        MapPicture map = CharacterMap.Draw(MapModel.Of(MadeUpFlight.Record()), 44, 13, isUnicode: false);

        Assert.All(map.Lines, l => Assert.DoesNotContain(l, c => c is < ' ' or > '~'));
        Assert.Contains(map.Lines, l => l.Contains("+++"));
    }

    [Fact]
    public void Draw_PlacesThatMakeNoSense_AreLeftOut()
    {
        var wild = new MapModel
        {
            Area = [new(double.NaN, 0, 0), new(1e12, 5, 0), new(0, double.PositiveInfinity, 0)],
            Path = [new(0, 0, 0), new(5e5, 5e5, 0), new(double.NaN, 1, 0)],
            Vehicle = new NedPosition(double.NaN, double.NaN, 0),
            Home = new NedPosition(1e300, 0, 0),
        };

        Assert.Equal(13, CharacterMap.Draw(wild, 44, 13).Lines.Count);
        Assert.Equal(13, CharacterMap.Draw(new MapModel(), 44, 13).Lines.Count);
    }

    [Fact]
    public void Draw_SameModelTwice_IsTheSame()
    {
        MapModel model = MapModel.Of(MadeUpFlight.Record());

        Assert.Equal(CharacterMap.Draw(model, 60, 20).Lines, CharacterMap.Draw(model, 60, 20).Lines);
    }

    private static MapTrack Track(
        TargetClassName colour, double north, double east, TrackState state = TrackState.Confirmed,
        double variance = 0.5)
        => new(new NedPosition(north, east, 0), new TargetTrack
        {
            Id = 1,
            Class = colour,
            State = state,
            Covariance = new HorizontalCovariance(variance, 0, variance)
        });

    private static (int Column, int Row) Find(MapPicture map, char mark)
    {
        int row = map.Lines.ToList().FindIndex(l => l.Contains(mark));
        Assert.True(row >= 0, $"No '{mark}' on\n" + string.Join("\n", map.Lines));
        return (map.Lines[row].IndexOf(mark), row);
    }

    private static int Ink(MapPicture map, MapInk ink)
        => Enumerable.Range(0, map.Lines.Count)
            .Sum(row => Enumerable.Range(0, map.Lines[row].Length).Count(column => map.InkAt(column, row) == ink));
}
