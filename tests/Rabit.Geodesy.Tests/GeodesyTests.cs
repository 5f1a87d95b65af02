using System;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Geodesy.Tests;

public sealed class GeodesyTests(ITestOutputHelper output)
{
    private const double Metres = 1e-6;
    private const double Degrees = 1e-9;
    private const double EarthRadius = 6_378_137;
    private const double Undulation = 47.2;

    [Fact]
    public void Ecef_Vectors_AgreeBothWays()
    {
        (double worst, double worstBack) = (0, 0);
        foreach (JsonElement c in Vectors.Geodesy.Each("ecef"))
        {
            var place = new EllipsoidPosition(Point(c, "lat", "lon"), new EllipsoidHeight(c.Number("h")));
            EcefPosition ecef = place.ToEcef();
            var expected = new EcefPosition(c.Number("x"), c.Number("y"), c.Number("z"));
            worst = Math.Max(worst, Distance(expected, ecef));

            EllipsoidPosition back = EllipsoidPosition.FromEcef(expected);
            double latitude = back.Point.Latitude.Degrees - c.Number("lat");
            Assert.True(Math.Abs(latitude) <= Degrees, $"{c}: latitude off by {latitude}");
            if (!c.TryGetProperty("lon_undefined", out _) && !c.TryGetProperty("lon_ill_conditioned", out _))
                Assert.True(
                    Math.Abs(Turn(back.Point.Longitude.Degrees, c.Number("lon"))) <= Degrees,
                    $"{c}: longitude {back.Point.Longitude}");
            worstBack = Math.Max(
                worstBack, Math.Max(Distance(expected, back.ToEcef()), Math.Abs(back.Height.Metres - c.Number("h"))));
        }

        output.WriteLine($"ECEF {worst:E1} m, back {worstBack:E1} m");
        Assert.True(worst <= Metres && worstBack <= Metres);
    }

    [Fact]
    public void LocalFrame_Vectors_AgreesBothWays()
    {
        JsonElement[] origins = [.. Vectors.Geodesy.Each("enu_origins")];
        double worst = 0;
        foreach (JsonElement c in Vectors.Geodesy.Each("enu"))
        {
            var frame = new LocalNedFrame(EllipsoidPlace(origins[c.GetProperty("origin").GetInt32()]), Undulation);
            NedPosition ned = frame.ToNed(EllipsoidPlace(c));
            worst = Math.Max(worst, Math.Abs(ned.North - c.Number("n")));
            worst = Math.Max(worst, Math.Abs(ned.East - c.Number("e")));
            worst = Math.Max(worst, Math.Abs(ned.Down + c.Number("u")));
            var expected = new NedPosition(c.Number("n"), c.Number("e"), -c.Number("u"));
            worst = Math.Max(worst, Distance(EllipsoidPlace(c).ToEcef(), frame.ToEllipsoid(expected).ToEcef()));
            worst = Math.Max(
                worst,
                Distance(EllipsoidPlace(c).ToEcef(), frame.ToGeodetic(expected).ToEllipsoid(Undulation).ToEcef()));
        }

        output.WriteLine($"local frame {worst:E1} m");
        Assert.True(worst <= Metres);
    }

    [Fact]
    public void LocalFrame_AltitudesAboveTheSea_BecomeHeightsByTheUndulationOnly()
    {
        GeodeticPosition sea = GeodeticPosition.FromDegrees(47, 8, 400);
        var frame = new LocalNedFrame(sea, Undulation);
        Assert.Equal(0, frame.ToNed(sea.ToEllipsoid(Undulation)).Down, Metres);
        Assert.Equal(-Undulation, frame.ToNed(sea.ToEllipsoid(2 * Undulation)).Down, Metres);
        Assert.Equal(400, frame.ToGeodetic(default).AltitudeAmslMetres, Metres);
        Assert.Equal(400 + Undulation, frame.ToEllipsoid(default).Height.Metres, Metres);
        Assert.Equal(Undulation, frame.GeoidUndulationMetres);
        Assert.Equal(400, new LocalNedFrame(sea.ToEllipsoid(Undulation), Undulation).Origin.AltitudeAmslMetres, Metres);

        // What ignoring it costs: 10 km are 7.4 cm longer 47 m higher up.
        GeodeticPosition far = GeodeticPosition.FromDegrees(47.09, 8, 400);
        double north = frame.ToNed(far).North;
        Assert.Equal(north * Undulation / EarthRadius, north - LocalNedFrame.IgnoringGeoid(sea).ToNed(far).North, 1e-3);
    }

    [Fact]
    public void Direct_Vectors_ArriveThere()
    {
        (double worst, double worstTurn) = (0, 0);
        foreach (JsonElement c in Vectors.Geodesy.Each("geodesic_direct"))
        {
            GeographicPoint end = Geodesic.Direct(
                Point(c, "lat1", "lon1"), Angle.FromDegrees(c.Number("azi1")), c.Number("s12"), out Angle azimuth);
            worst = Math.Max(worst, Distance(Point(c, "lat2", "lon2"), end));
            double pole = Math.Cos(c.Radians("lat2"));
            worstTurn = Math.Max(
                worstTurn, Math.Abs(Turn(azimuth.Degrees, c.Number("azi2"))) * Math.Min(1, pole * 1e3));
        }

        output.WriteLine($"direct {worst:E1} m, azimuth {worstTurn:E1} deg");
        Assert.True(worst <= 1e-9 * Vectors.Degree * EarthRadius, $"{worst}");
        Assert.True(worstTurn <= Degrees, $"{worstTurn}");
    }

    [Fact]
    public void Inverse_Vectors_GiveLengthAndAzimuths()
    {
        (double worst, double worstTurn, double worstEnd) = (0, 0, 0);
        foreach (JsonElement c in Vectors.Geodesy.Each("geodesic_inverse"))
        {
            GeodesicLine line = Geodesic.Inverse(Point(c, "lat1", "lon1"), Point(c, "lat2", "lon2"));
            double metres = c.Number("s12");
            double error = Math.Abs(line.DistanceMetres - metres);
            Assert.True(error <= Metres, $"{c}: {line.DistanceMetres:R}");
            worst = Math.Max(worst, error);

            // That the azimuths lead there holds everywhere, also where they are not the only ones.
            GeographicPoint end = Geodesic.Direct(
                Point(c, "lat1", "lon1"), line.StartAzimuth, line.DistanceMetres, out _);
            double off = Distance(Point(c, "lat2", "lon2"), end);
            Assert.True(off <= Metres, $"{c}: {line.StartAzimuth.Degrees:R} leads {off} m beside");
            worstEnd = Math.Max(worstEnd, off);
            if (c.TryGetProperty("azi_not_unique", out _) || c.TryGetProperty("nearly_antipodal", out _))
                continue;
            double turn = Math.Max(
                Math.Abs(Turn(line.StartAzimuth.Degrees, c.Number("azi1"))),
                Math.Abs(Turn(line.EndAzimuth.Degrees, c.Number("azi2"))));

            // The reference, which was computed with doubles, is itself up to 1.4 nm beside on lines below 100 m
            // (against 40 digits).
            bool isGood = turn <= Degrees || (metres < 100 && turn * Vectors.Degree * metres <= 3e-9);
            Assert.True(isGood, $"{c}: {line.StartAzimuth.Degrees:R} {line.EndAzimuth.Degrees:R}");
            if (metres >= 100)
                worstTurn = Math.Max(worstTurn, turn);
        }

        output.WriteLine($"inverse {worst:E1} m, azimuth from 100 m {worstTurn:E1} deg, leads {worstEnd:E1} m beside");
    }

    [Fact]
    public void Inverse_SamePlaceOrTurnedRound_IsConsistent()
    {
        var numbers = new SeededNumbers(5);
        GeographicPoint here = new(Angle.FromDegrees(47), Angle.FromDegrees(8));
        Assert.Equal(0, Geodesic.Inverse(here, here).DistanceMetres, 1e-9);
        for (int i = 0; i < 300; i++)
        {
            GeographicPoint a = new(
                Angle.FromDegrees(numbers.Uniform(-90, 90)), Angle.FromDegrees(numbers.Uniform(-180, 180)));
            GeographicPoint b = new(
                Angle.FromDegrees(numbers.Uniform(-90, 90)), Angle.FromDegrees(numbers.Uniform(-180, 180)));
            double there = Geodesic.Inverse(a, b).DistanceMetres;
            Assert.True(Math.Abs(there - Geodesic.Inverse(b, a).DistanceMetres) < 1e-7, $"seed 5, case {i}");
            Assert.True(there < 20_003_932, $"seed 5, case {i}: no way is longer than half a meridian");
        }
    }

    [Fact]
    public void Utm_Vectors_AgreeBothWays()
    {
        (double worst, double worstTurn, double worstScale) = (0, 0, 0);
        foreach (JsonElement c in Vectors.Geodesy.Each("utm_mgrs"))
        {
            UtmPosition utm = UtmPosition.From(Point(c, "lat", "lon"), out Angle convergence, out double scale);
            Assert.Equal(c.GetProperty("zone").GetInt32(), utm.Zone);
            Assert.Equal(c.GetProperty("north").GetBoolean(), utm.IsNorth);
            worst = Math.Max(worst, Math.Abs(utm.EastingMetres - c.Number("easting")));
            worst = Math.Max(worst, Math.Abs(utm.NorthingMetres - c.Number("northing")));
            worst = Math.Max(worst, Distance(Point(c, "lat", "lon"), utm.ToGeographic()));
            worstTurn = Math.Max(worstTurn, Math.Abs(convergence.Degrees - c.Number("convergence")));
            worstScale = Math.Max(worstScale, Math.Abs(scale - c.Number("scale")));
        }

        output.WriteLine($"UTM {worst:E1} m, convergence {worstTurn:E1} deg, scale {worstScale:E1}");
        Assert.True(worst <= Metres && worstTurn <= 1e-6 && worstScale <= 1e-7, $"{worst} {worstTurn} {worstScale}");
    }

    [Fact]
    public void Mgrs_Vectors_AgreeBothWays()
    {
        foreach (JsonElement c in Vectors.Geodesy.Each("utm_mgrs"))
        {
            string expected = c.GetProperty("mgrs").GetString()!;
            MgrsPosition square = MgrsPosition.From(Point(c, "lat", "lon"));
            Assert.Equal(expected, square.ToString());
            Assert.Equal(c.GetProperty("band").GetString(), square.Band.ToString());
            Assert.True(MgrsPosition.TryParse(expected.ToLowerInvariant(), out MgrsPosition parsed), expected);
            Assert.Equal(c.Number("mgrs_corner_easting"), parsed.Corner.EastingMetres);
            Assert.Equal(c.Number("mgrs_corner_northing"), parsed.Corner.NorthingMetres);
            Assert.True(Distance(Point(c, "mgrs_corner_lat", "mgrs_corner_lon"), parsed.Corner.ToGeographic()) < 1e-5);
            for (int digits = 0; digits <= 5; digits++)
            {
                string text = MgrsPosition.From(Point(c, "lat", "lon"), digits).ToString();
                Assert.True(MgrsPosition.TryParse(text, out parsed), text);
                Assert.Equal(text, parsed.ToString());
            }
        }
    }

    // Near the upper edge of a band the corner of a coarse square is north of it; at the left side of a zone too.
    [Theory]
    [InlineData("13SGE2231")]
    [InlineData("13UFC81")]
    [InlineData("52VFS")]
    [InlineData("60VXS")]
    [InlineData("01CDA31")]
    [InlineData("45DUK")]
    public void Mgrs_CoarseSquareAtTheEdgeOfABand_IsRead(string text)
    {
        Assert.True(MgrsPosition.TryParse(text, out MgrsPosition square));
        Assert.Equal(text, square.ToString());
    }

    [Theory]
    [InlineData("32SMT6500050000")]
    [InlineData("32UMT6500050000")]
    public void Mgrs_LettersOfAnotherBand_AreRefused(string text) => Assert.False(MgrsPosition.TryParse(text, out _));

    [Fact]
    public void Mgrs_AnyPlaceAndDigits_ComesBack()
    {
        var numbers = new SeededNumbers(41);
        for (int i = 0; i < 20_000; i++)
        {
            // Every other place lies within a kilometre of the edge of a band, every third one of that of a zone.
            double latitude = i % 2 == 0
                ? numbers.Uniform(-80, 84)
                : -80 + (8 * numbers.Below(21)) + numbers.Uniform(-0.01, 0.01);
            double longitude = i % 3 == 0
                ? -180 + (6 * numbers.Below(61)) + numbers.Uniform(-0.01, 0.01)
                : numbers.Uniform(-180, 180);
            var point = new GeographicPoint(
                Angle.FromDegrees(Math.Max(-80, Math.Min(84, latitude))), Angle.FromDegrees(longitude));
            for (int digits = 0; digits <= 5; digits++)
            {
                string text = MgrsPosition.From(point, digits).ToString();
                Assert.True(
                    MgrsPosition.TryParse(text, out MgrsPosition back) && back.ToString() == text,
                    $"seed 41, case {i}: {point} as {text}");
            }
        }
    }

    [Fact]
    public void Utm_NearThePoles_IsRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(
            () => UtmPosition.From(new GeographicPoint(Angle.FromDegrees(84.1), Angle.Zero)));
        Assert.Contains("(UPS)", Assert.Throws<ArgumentOutOfRangeException>(
            () => MgrsPosition.From(new GeographicPoint(Angle.FromDegrees(-80.1), Angle.Zero))).Message);
        Assert.Throws<ArgumentOutOfRangeException>(
            () => MgrsPosition.From(new GeographicPoint(Angle.FromDegrees(double.NaN), Angle.Zero)));
        Assert.False(MgrsPosition.TryParse("ZAH0000000000", out _));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => UtmPosition.From(new GeographicPoint(Angle.FromDegrees(double.NaN), Angle.Zero)));
        Assert.Throws<InvalidOperationException>(() => new UtmPosition(61, true, 5e5, 5e6).ToGeographic());
    }

    [WholeVectorsFact]
    public void Vectors_WholeSets_AreTheOnesThatAreTested()
    {
        Assert.Equal(
            (616, 600, 444, 300, 143),
            (Count("ecef"), Count("enu"), Count("geodesic_inverse"), Count("geodesic_direct"), Count("utm_mgrs")));
        Assert.Equal((716, 100, 240), (Vectors.Attitude.Each("cases").Count(),
            Vectors.Attitude.Each("multiply").Count(), Vectors.Attitude.Each("slerp").Count()));
        Assert.Equal(
            (1082, 147, 160, 160),
            (Vectors.Geolocation.Each("flat").Count(), Vectors.Geolocation.Each("dem").Count(),
                Vectors.Geolocation.Each("series_images").Count(), Vectors.Geolocation.Each("covariance").Count()));

        static int Count(string list) => Vectors.Geodesy.Each(list).Count();
    }

    internal static GeographicPoint Point(JsonElement c, string latitude, string longitude)
        => new(Angle.FromDegrees(c.Number(latitude)), Angle.FromDegrees(c.Number(longitude)));

    private static EllipsoidPosition EllipsoidPlace(JsonElement c)
        => new(Point(c, "lat", "lon"), new EllipsoidHeight(c.Number("h")));

    private static double Distance(GeographicPoint a, GeographicPoint b)
        => Distance(new EllipsoidPosition(a, default).ToEcef(), new EllipsoidPosition(b, default).ToEcef());

    private static double Distance(EcefPosition a, EcefPosition b) => a.DistanceTo(b);

    private static double Turn(double a, double b) => Math.IEEERemainder(a - b, 360);
}
