using System;
using System.IO;
using System.Text;
using Xunit;

namespace Rabit.Geodesy.Tests;

/// <summary>Grids of 30 degrees, made by the test: 12 columns, 7 rows.</summary>
public sealed class GeoidGridTests
{
    private const int Rows = 7;
    private const int Columns = 12;
    private const string Header =
        "P5\n# Geoid file\n# Description test\n# Offset -108\n# Scale 0.003\n# Origin 90N 0E\n12 7\n65535\n";

    [Fact]
    public void UndulationMetres_AtPostsAndBetween_IsBilinear()
    {
        GeoidGrid grid = Grid((row, column) => (3 * row) - (2 * column));
        Assert.Equal(30, grid.Step.Degrees);
        Assert.Equal(0, Undulation(grid, 90, 0), 0.0015);
        Assert.Equal(3 - 4, Undulation(grid, 60, 60), 0.0015);
        Assert.Equal(3 + 1.5 - 4 - 1, Undulation(grid, 45, 75), 0.0015);
        Assert.Equal(18 - 22, Undulation(grid, -90, -30), 0.0015);
    }

    [Fact]
    public void UndulationMetres_BeyondTheLastColumn_GoesOnWithTheFirst()
    {
        GeoidGrid grid = Grid((row, column) => column == 0 ? 20 : column == 11 ? 10 : 0);
        Assert.Equal(15, Undulation(grid, 10, -15), 0.0015);
        Assert.Equal(15, Undulation(grid, 10, 345), 0.0015);
        Assert.Equal(20, Undulation(grid, 10, 360), 0.0015);
        Assert.Equal(20, Undulation(grid, 10, -1e-17), 0.0015);
        Assert.Equal(0, Undulation(grid, 10, 180), 0.0015);
        Assert.Equal(0, Undulation(grid, 10, -180), 0.0015);
    }

    [Fact]
    public void UndulationMetres_NoPlace_IsRefused()
    {
        GeoidGrid grid = Grid((row, column) => 1);
        Assert.Throws<ArgumentException>(() => Undulation(grid, 91, 0));
        Assert.Throws<ArgumentException>(() => Undulation(grid, 0, double.NaN));
    }

    [Theory]
    [InlineData("P5", "P2", "P5")]
    [InlineData("# Offset -108\n", "", "Offset")]
    [InlineData("# Scale 0.003", "# Scale 0", "Scale")]
    [InlineData("Scale 0.003", "Scale x", "'x'")]
    [InlineData("90N 0E", "90S 0E", "90S")]
    [InlineData("12 7", "12 8", "12 x 8")]
    [InlineData("12 7", "twelve", "'twelve'")]
    [InlineData("65535", "255", "16 bits")]
    public void ReadPgm_BadHeader_SaysWhy(string old, string other, string text)
    {
        using var stream = new MemoryStream(Pgm(Header.Replace(old, other), (row, column) => 0));
        Assert.Contains(
            text, Assert.Throws<FormatException>(() => GeoidPgm.Read(stream)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void ReadPgm_TooShortOrTooLong_IsRefused()
    {
        byte[] file = Pgm(Header, (row, column) => 0);
        Assert.Contains(
            "row 7 of 7",
            Assert.Throws<FormatException>(() => GeoidPgm.Read(new MemoryStream(file, 0, file.Length - 1))).Message);
        Assert.Contains(
            "header", Assert.Throws<FormatException>(() => GeoidPgm.Read(new MemoryStream(file, 0, 20))).Message);
        Array.Resize(ref file, file.Length + 1);
        Assert.Contains("goes on", Assert.Throws<FormatException>(() => GeoidPgm.Read(new MemoryStream(file))).Message);
    }

    [Fact]
    public void ReadDac_CentimetresWithASign_AreMetres()
    {
        const int AllColumns = 1440;
        var file = new byte[2 * 721 * AllColumns];
        Put(0, 1361);                               // north pole: 13.61 m, as in the true file
        Put((360 * AllColumns) + 4, -10699);        // 0 N 1 E
        GeoidGrid grid = Egm96Dac.Read(new MemoryStream(file));
        Assert.Equal(13.61, Undulation(grid, 90, 0), 1e-9);
        Assert.Equal(-106.99, Undulation(grid, 0, 1), 1e-9);
        Assert.Equal(-106.99 / 2, Undulation(grid, 0, 1.125), 1e-9);
        Assert.Throws<FormatException>(() => Egm96Dac.Read(new MemoryStream(file, 0, 1000)));

        void Put(int post, short value) => (file[2 * post], file[(2 * post) + 1]) = ((byte)(value >> 8), (byte)value);
    }

    [Fact]
    public void Positions_WithAGeoid_ComeFromOneHeightToTheOther()
    {
        GeoidGrid geoid = Grid((row, column) => 47.5);
        GeodeticPosition home = GeodeticPosition.FromDegrees(47, 8, 400);
        Assert.Equal(447.5, home.ToEllipsoid(geoid).Height.Metres, 0.002);
        Assert.Equal(400, home.ToEllipsoid(geoid).ToAmsl(geoid).AltitudeAmslMetres, 1e-9);
        Assert.Equal(47.5, new LocalNedFrame(home, geoid).GeoidUndulationMetres, 0.002);
        Assert.Equal(400, new LocalNedFrame(home.ToEllipsoid(geoid), geoid).Origin.AltitudeAmslMetres, 1e-9);
    }

    internal static GeoidGrid Grid(Func<int, int, double> undulation)
        => GeoidPgm.Read(new MemoryStream(Pgm(Header, undulation)));

    private static double Undulation(GeoidGrid grid, double latitude, double longitude)
        => grid.UndulationMetres(new GeographicPoint(Angle.FromDegrees(latitude), Angle.FromDegrees(longitude)));

    private static byte[] Pgm(string header, Func<int, int, double> undulation)
    {
        using var file = new MemoryStream();
        byte[] text = Encoding.ASCII.GetBytes(header);
        file.Write(text, 0, text.Length);
        for (int i = 0; i < Rows * Columns; i++)
        {
            int value = (int)Math.Round((undulation(i / Columns, i % Columns) + 108) / 0.003);
            file.WriteByte((byte)(value >> 8));
            file.WriteByte((byte)value);
        }

        return file.ToArray();
    }
}
