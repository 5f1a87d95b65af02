using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using System.Xml.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Reporting.Tests.ExportedText;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>Exports of a flight, as a reader of the format sees them who knows nothing of us.</summary>
public sealed class FlightExportTests
{
    private static readonly XNamespace Kml = "http://www.opengis.net/kml/2.2";

    private static readonly string[] EveryKind =
        ["home", "area", "fence", "lane", "coverage", "path", "target", "ellipse95", "truth"];

    private static FlightSummary Flight => MadeUpFlight.Summary(MadeUpFlight.Record(hasFalseTrack: true));

    [Fact]
    public void WriteGeoJson_AFlight_HasEveryKindOfFeature()
        => Assert.Equal(
            EveryKind.OrderBy(k => k, StringComparer.Ordinal),
            Features(Flight).Select(KindOf).Distinct().OrderBy(k => k, StringComparer.Ordinal));

    [Fact]
    public void WriteGeoJson_Positions_AreLongitudeThenLatitudeAndNearHome()
    {
        double[][] positions = [.. Features(Flight).SelectMany(f => PositionsOf(f.GetProperty("geometry")))];

        Assert.All(positions, p => Assert.Equal(2, p.Length));
        Assert.All(positions, p => Assert.InRange(p[0], 8.54, 8.55));
        Assert.All(positions, p => Assert.InRange(p[1], 47.39, 47.41));
    }

    [Fact]
    public void WriteGeoJson_Polygons_AreClosedWithOutlinesCounterClockwiseAndHolesClockwise()
    {
        JsonElement[] polygons = [.. Features(Flight).SelectMany(f => PolygonsOf(f.GetProperty("geometry")))];

        Assert.InRange(polygons.Length, 9, 100);
        foreach (JsonElement polygon in polygons)
        {
            double[][][] rings =
                [.. polygon.EnumerateArray().Select(r => r.EnumerateArray().Select(Numbers).ToArray())];
            Assert.All(rings, r => Assert.InRange(r.Length, 4, int.MaxValue));
            Assert.All(rings, r => Assert.Equal(r[0], r[r.Length - 1]));
            Assert.True(SignedArea(rings[0]) > 0);
            Assert.All(rings.Skip(1), r => Assert.True(SignedArea(r) < 0));
        }
    }

    [Fact]
    public void Write_KeepOuts_AreInEachOfThem()
    {
        SearchPlan plan = MadeUpSite.Plan;
        ImmutableArray<GeodeticPosition> keepOut = [plan.Area[0], plan.Area[1], plan.Area[2]];
        var with = new SearchPlan { Area = plan.Area, Home = plan.Home, KeepOuts = [keepOut, keepOut] };
        var summary = new FlightSummary(FlightRecord.Empty.WithLatest(new MissionStatus { Plan = with }, default));

        Assert.Equal(2, Features(summary).Count(f => KindOf(f) == "keep-out"));
        XDocument kml = XDocument.Parse(Text(FlightExport.WriteKml, summary));
        Assert.Equal(2, kml.Descendants(Kml + "styleUrl").Count(s => s.Value == "#keep-out"));
        string[] lines = Text(FlightExport.WriteCsv, summary).Split('\n');
        Assert.Equal(8, lines.Count(l => l.StartsWith("keep-out", StringComparison.Ordinal)));
    }

    [Fact]
    public void WriteGeoJson_ClockwiseArea_IsTurned()
    {
        SearchPlan plan = MadeUpSite.Plan;
        var turned = new SearchPlan { Area = [.. plan.Area.Reverse()], Home = plan.Home };
        FlightRecord record = FlightRecord.Empty.WithLatest(new MissionStatus { Plan = turned }, default);

        JsonElement area = Features(new FlightSummary(record)).Single(f => KindOf(f) == "area");

        Assert.True(SignedArea(PositionsOf(area.GetProperty("geometry"))) > 0);
    }

    [Fact]
    public void WriteGeoJson_Path_HasATimeAndAHeightForEachPlace()
    {
        FlightSummary flight = Flight;
        JsonElement path = Features(flight).Single(f => KindOf(f) == "path");
        int places = PositionsOf(path.GetProperty("geometry")).Length;

        Assert.Equal(flight.Record.Samples.Count(s => s.HasPosition), places);
        foreach (string name in new[] { "timeSeconds", "altitudeAmslMetres", "heightAboveHomeMetres" })
            Assert.Equal(places, path.GetProperty("properties").GetProperty(name).GetArrayLength());
    }

    [Fact]
    public void WriteGeoJson_Ellipse_IsAsWideAsItsCovariance()
    {
        FlightSummary flight = Flight;
        foreach (TargetTrack track in flight.Record.Tracks.Confirmed)
        {
            JsonElement ellipse = Features(flight)
                .Single(f => KindOf(f) == "ellipse95" && NumberOf(f) == track.Id);
            var frame = LocalNedFrame.IgnoringGeoid(track.Position);
            NedPosition[] edge =
            [
                .. PositionsOf(ellipse.GetProperty("geometry"))
                    .Select(p => frame.ToNed(GeodeticPosition.FromDegrees(p[1], p[0], 0))),
            ];

            // Each corner on the edge of what Contains95 says, to the rounding of a position.
            Assert.All(edge, e => Assert.True(track.Covariance.Contains95(e.North * 0.98, e.East * 0.98)));
            Assert.All(edge, e => Assert.False(track.Covariance.Contains95(e.North * 1.02, e.East * 1.02)));
        }
    }

    [Fact]
    public void WriteGeoJson_Coverage_HoldsWhatThePicturesShowAndNoMore()
    {
        FlightSummary flight = Flight;
        JsonElement coverage = Features(flight).Single(f => KindOf(f) == "coverage");
        double[][][][] patches =
        [
            .. PolygonsOf(coverage.GetProperty("geometry")).Select(
                p => p.EnumerateArray().Select(r => r.EnumerateArray().Select(Numbers).ToArray()).ToArray()),
        ];
        bool IsSeen(double longitude, double latitude)
            => patches.Any(p => p.Count(r => IsInside(r, longitude, latitude)) % 2 == 1);

        foreach (CameraObservation o in flight.Record.Observations.Where((_, index) => index % 20 == 0))
        {
            Assert.True(IsSeen(
                (o.TopLeft.Longitude.Degrees + o.BottomRight.Longitude.Degrees) / 2,
                (o.TopLeft.Latitude.Degrees + o.BottomRight.Latitude.Degrees) / 2));
        }

        Assert.False(IsSeen(MadeUpSite.Home.Longitude.Degrees - 0.001, MadeUpSite.Home.Latitude.Degrees));
    }

    [Fact]
    public void WriteGeoJson_PicturesAroundAPlaceNotSeen_HaveAHole()
    {
        JsonElement coverage = Features(new FlightSummary(Seen((0, 0, 60, 20), (0, 40, 60, 60), (0, 10, 20, 50),
            (40, 10, 60, 50)))).Single(f => KindOf(f) == "coverage");

        JsonElement polygon = Assert.Single(PolygonsOf(coverage.GetProperty("geometry")));
        double[][][] rings = [.. polygon.EnumerateArray().Select(r => r.EnumerateArray().Select(Numbers).ToArray())];
        Assert.Equal(2, rings.Length);
        Assert.InRange(SignedArea(rings[0]) / -SignedArea(rings[1]), 8.5, 9.5);
    }

    [Fact]
    public void WriteGeoJson_PicturesApart_ArePatchesOfTheirOwn()
    {
        JsonElement coverage = Features(new FlightSummary(Seen((0, 0, 10, 10), (30, 30, 40, 40))))
            .Single(f => KindOf(f) == "coverage");

        Assert.Equal(2, PolygonsOf(coverage.GetProperty("geometry")).Count());
    }

    [Fact]
    public void WriteKml_AFlight_HasLongitudeFirstAndClosedRings()
    {
        XDocument kml = XDocument.Parse(Text(FlightExport.WriteKml, Flight));

        Assert.Equal(Kml + "kml", kml.Root!.Name);
        double[][] places = [.. kml.Descendants(Kml + "coordinates").SelectMany(Places)];
        Assert.All(places, p => Assert.InRange(p[0], 8.54, 8.55));
        Assert.All(places, p => Assert.InRange(p[1], 47.39, 47.41));
        Assert.All(
            kml.Descendants(Kml + "LineString").Elements(Kml + "coordinates").SelectMany(Places),
            p => Assert.InRange(p[2], 480, 540));
        double[][][] rings =
            [.. kml.Descendants(Kml + "LinearRing").Select(r => Places(r.Element(Kml + "coordinates")!))];
        Assert.InRange(rings.Length, 9, 100);
        Assert.All(rings, r => Assert.Equal(r[0], r[r.Length - 1]));
        string[] styles = [.. kml.Descendants(Kml + "Style").Select(s => "#" + s.Attribute("id")!.Value)];
        Assert.All(kml.Descendants(Kml + "styleUrl"), s => Assert.Contains(s.Value, styles));
        Assert.Contains(kml.Descendants(Kml + "name"), n => n.Value == "3 blue");
    }

    [Fact]
    public void Write_HostileName_IsATextAndNothingElse()
    {
        var plan = new SearchPlan
        {
            Name = "</name><script>\u0007\uD800\uFFFF \"quoted\" & so on",
            Home = MadeUpSite.Home,
            Area = MadeUpSite.Plan.Area,
        };
        var summary = new FlightSummary(
            FlightRecord.Empty.WithLatest(new MissionStatus { Plan = plan }, default));

        XDocument kml = XDocument.Parse(Text(FlightExport.WriteKml, summary));
        Assert.Contains("</name><script>... \"quoted\" & so on", kml.Descendants(Kml + "name").Select(n => n.Value));
        Assert.Contains(
            Features(summary),
            f => f.GetProperty("properties").TryGetProperty("name", out JsonElement name)
                && name.GetString() == "</name><script>... \"quoted\" & so on");
    }

    [Fact]
    public void WriteCsv_AnyCulture_IsATableWithUnitsAndPoints()
    {
        CultureInfo before = Thread.CurrentThread.CurrentCulture;
        var comma = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        comma.NumberFormat.NumberDecimalSeparator = ",";
        comma.NumberFormat.NegativeSign = "~";
        Thread.CurrentThread.CurrentCulture = comma;
        try
        {
            string[] lines = Text(FlightExport.WriteCsv, Flight)
                .Split(["\r\n"], StringSplitOptions.RemoveEmptyEntries);
            string[] columns = lines[0].Split(',');
            Dictionary<string, string>[] rows =
            [
                .. lines.Skip(1).Select(l => l.Split(',')).Select(
                    fields => columns.Zip(fields, (c, f) => (c, f)).ToDictionary(p => p.c, p => p.f)),
            ];

            Assert.All(lines, l => Assert.Equal(columns.Length, l.Split(',').Length));
            Assert.Equal(
                EveryKind.Where(k => k != "ellipse95").OrderBy(k => k, StringComparer.Ordinal),
                rows.Select(r => r["kind"]).Distinct().OrderBy(k => k, StringComparer.Ordinal));
            Assert.All(rows, r => Assert.InRange(Number(r["latitude_deg"]), 47.39, 47.41));
            Assert.All(rows, r => Assert.InRange(Number(r["longitude_deg"]), 8.54, 8.55));
            Assert.InRange(Number(rows.First(r => r["kind"] == "target")["ellipse95_half_major_m"]), 1, 5);
        }
        finally
        {
            Thread.CurrentThread.CurrentCulture = before;
        }
    }

    [Fact]
    public void Write_NothingWasFlown_IsAnEmptyDocumentOfTheFormat()
    {
        var nothing = new FlightSummary(FlightRecord.Empty);

        Assert.Empty(Features(nothing));
        Assert.Empty(XDocument.Parse(Text(FlightExport.WriteKml, nothing)).Descendants(Kml + "Placemark"));
        Assert.Single(Text(FlightExport.WriteCsv, nothing).Split(["\r\n"], StringSplitOptions.RemoveEmptyEntries));
    }

    [Fact]
    public void Write_AnyFormat_LeavesTheStreamOpen()
    {
        using var stream = new MemoryStream();

        FlightExport.WriteGeoJson(stream, Flight);
        FlightExport.WriteKml(stream, Flight);
        FlightExport.WriteCsv(stream, Flight);

        Assert.True(stream.CanWrite);
    }

    [Fact]
    public void Write_TrackWithoutEllipse_IsATargetAllTheSame()
    {
        var track = new TargetTrack
        {
            Id = 4,
            State = TrackState.Confirmed,
            Position = MadeUpSite.Home,
            Covariance = new HorizontalCovariance(double.NaN, 0, double.PositiveInfinity),
        };
        var summary = new FlightSummary(new FlightRecord { Tracks = new TrackList(TimeSpan.Zero, [track]) });

        Assert.Equal(["target"], Features(summary).Select(KindOf));
        Assert.NotEmpty(Text(FlightExport.WriteKml, summary));
        Assert.NotEmpty(Text(FlightExport.WriteCsv, summary));
    }

    private static FlightRecord Seen(params (double South, double West, double North, double East)[] pictures) => new()
    {
        Observations =
        [
            .. pictures.Select(p => new CameraObservation
            {
                TopLeft = Place(p.North, p.West),
                TopRight = Place(p.North, p.East),
                BottomRight = Place(p.South, p.East),
                BottomLeft = Place(p.South, p.West),
            }),
        ],
    };

    private static GeodeticPosition Place(double north, double east)
        => MadeUpSite.Frame.ToGeodetic(new NedPosition(north, east, 0));
}
