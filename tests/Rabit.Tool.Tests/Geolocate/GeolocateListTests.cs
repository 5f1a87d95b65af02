using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Xunit;

namespace Rabit.Tool.Tests.Geolocate;

/// <summary><c>rabit geolocate</c> of several pixels at once, and its file for maps.</summary>
public sealed class GeolocateListTests : IDisposable
{
    private const string List = "[[319.5,239.5],[640,10],[419.5,339.5]]";

    private readonly GeolocateFiles _run = new();
    private readonly string _camera;

    public GeolocateListTests() => _camera = _run.File("camera.json", GeolocateFiles.Camera);

    public void Dispose() => _run.Dispose();

    [Fact]
    public void Text_ListWithARefusedOne_IsOneLineForEachAndExitCode1()
    {
        Assert.Equal(1, _run.Run(_camera, Request(List)));

        string[] lines = _run.Output.TrimEnd().Split('\n');
        Assert.Equal(3, lines.Length);
        Assert.StartsWith("pixel 319.5,239.5: 47.0000000, 8.0000000  altitude 500.00 m  95 % ellipse ", lines[0]);
        Assert.StartsWith("pixel 640,10: refused: OutsidePicture: the pixel", lines[1]);
        Assert.StartsWith("pixel 419.5,339.5: 46.99993", lines[2]);
    }

    [Fact]
    public void Json_List_IsAnArrayOfWhatEachWouldGiveAlone()
    {
        Assert.Equal(1, _run.Run(_camera, Request(List), "--json"));
        string[] together = [.. _run.Json.EnumerateArray().Select(e => e.GetRawText().Replace("\n  ", "\n"))];

        string[] pixels = ["319.5,239.5", "640,10", "419.5,339.5"];
        string[] alone = [.. pixels.Select(pixel =>
        {
            _run.Run(_camera, Request(List), "--pixel", pixel, "--json");
            return _run.Output.TrimEnd();
        })];

        Assert.Equal(alone, together);
        Assert.Equal(3, alone.Distinct().Count());
    }

    [Fact]
    public void Json_ListOfOne_IsAnArray()
    {
        Assert.Equal(0, _run.Run(_camera, Request("[[1,2]]"), "--json"));
        Assert.Equal((1, "ok"), (_run.Json.GetArrayLength(), _run.Json[0].Text("status")));
        Assert.Equal(0, _run.Run(_camera, Request("[[1,2]]")));
        Assert.StartsWith("pixel 1,2: ", _run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Pixels_AreManyButNotTooMany()
    {
        string Many(int count) => Request("[" + string.Join(",", Enumerable.Repeat("[1,2]", count)) + "]");
        Assert.Equal(0, _run.Run(_camera, Many(10_000)));
        Assert.Equal(10_000, _run.Output.TrimEnd().Split('\n').Length);
        Assert.Equal(2, _run.Run(_camera, Many(10_001)));
        Assert.EndsWith("request.json: pixels has 10001 entries; it may have 10000 at most", _run.Errors.TrimEnd());
    }

    [Theory]
    [InlineData("[]", "pixels is []; it must be a list of lists of two numbers, [[ ... ], ...]")]
    [InlineData("7", "pixels is 7; it must be a list of lists of two numbers, [[ ... ], ...]")]
    [InlineData("[1,2]", "pixels[0] is 1; it must be a list of two numbers")]
    [InlineData("[[1,2],[3,4],[5,6],[7]]", "pixels[3] is [7]; it must be a list of two numbers")]
    [InlineData("[[1,2],[3,4,5]]", "pixels[1] is [3,4,5]; it must be a list of two numbers")]
    [InlineData("[[1,2],null]", "pixels[1] is null; it must be a list of two numbers")]
    [InlineData("[[1,2],[3,\"4\"]]", "pixels[1][1] is \"4\"; it must be a number")]
    [InlineData("[[1,2],[1e999,4]]", "pixels[1][0] is 1e999; it must be a number")]
    [InlineData("[[1,2]],\"pixel\":[1,2]", "pixel and pixels exclude each other")]
    public void BadInput_Pixels_NamesFileAndFieldInOneLine(string pixels, string message)
    {
        string request = Request(pixels);

        Assert.Equal(2, _run.Run(_camera, request));

        Assert.Equal($"{request}: {message}", _run.Errors.TrimEnd());
        Assert.Empty(_run.Output);
    }

    [Fact]
    public void GeoJson_List_HasAPointAndAnEllipseForEachAndNoGeometryForARefusedOne()
    {
        string file = _run.File("places.geojson", new string('x', 100_000));

        Assert.Equal(1, _run.Run(_camera, Request(List), "--geojson", file, "--json"));

        JsonElement root = Root(file);
        Assert.Equal("FeatureCollection", root.Text("type"));
        JsonElement[] features = [.. root.GetProperty("features").EnumerateArray()];
        Assert.All(features, f => Assert.Equal("Feature", f.Text("type")));
        Assert.Equal(
            ["pixel Point", "ellipse95 Polygon", "pixel null", "pixel Point", "ellipse95 Polygon"],
            features.Select(KindAndGeometry));

        JsonElement refused = features[2].GetProperty("properties");
        Assert.Equal([640, 10], refused.Numbers("pixel"));
        Assert.Equal(
            ("refused", "OutsidePicture", "the pixel is not in the picture"),
            (refused.Text("status"), refused.Text("reason"), refused.Text("text")));
        AssertPlace(features[3], _run.Json[2]);
        AssertEllipse(Coordinates(features[4])[0], _run.Json[2]);
        Assert.Equal([419.5, 339.5], features[4].GetProperty("properties").Numbers("pixel"));
    }

    [Fact]
    public void GeoJson_OnePixel_IsWrittenBesideTheText()
    {
        string file = _run.PathOf("place.geojson");

        Assert.Equal(0, _run.Run(_camera, _run.File("request.json", GeolocateFiles.Pose), "--geojson", file));

        Assert.Equal(2, Root(file).GetProperty("features").GetArrayLength());
        Assert.StartsWith("47.0000000, 8.0000000", _run.Output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("180")]
    [InlineData("-180")]
    public void GeoJson_EllipseOnThe180thMeridian_IsCutThere(string longitude)
    {
        string file = _run.PathOf("place.geojson");
        string request = _run.File("request.json", GeolocateFiles.Pose.Replace(
            "\"longitudeDegrees\":8", "\"longitudeDegrees\":" + longitude));

        Assert.Equal(0, _run.Run(_camera, request, "--geojson", file));

        JsonElement ellipse = Root(file).GetProperty("features")[1];
        Assert.Equal("ellipse95 MultiPolygon", KindAndGeometry(ellipse));
        (double X, double Y)[][] rings = [.. Coordinates(ellipse).EnumerateArray().Select(p => Ring(p[0]))];
        Assert.Equal(2, rings.Length);
        Assert.All(rings, r => Assert.True(r[0] == r[r.Length - 1] && DoubleArea(r) > 0));
        Assert.All(rings[0], c => Assert.InRange(c.X, 179.99, 180));
        Assert.All(rings[1], c => Assert.InRange(c.X, -180, -179.99));
        Assert.Equal(DoubleArea(rings[0]), DoubleArea(rings[1]), DoubleArea(rings[0]) / 100);
    }

    [Fact]
    public void GeoJson_FileThatIsNone_IsNamed()
    {
        string request = _run.File("request.json", GeolocateFiles.Pose);

        Assert.Equal(2, _run.Run(_camera, request, "--geojson", request));
        Assert.StartsWith($"--geojson would overwrite {request}, which is read.", _run.Errors);
        Assert.Equal(GeolocateFiles.Pose, File.ReadAllText(request));
        Assert.Equal(2, _run.Run(_camera, request, "--geojson", _run.PathOf(".")));
        Assert.Contains("that is a folder", _run.Errors);
        string lost = Path.Combine(_run.PathOf("none"), "a.geojson");
        Assert.Equal(2, _run.Run(_camera, request, "--geojson", lost));
        Assert.StartsWith($"--geojson {lost}: it cannot be written: ", _run.Errors, StringComparison.Ordinal);
        Assert.Empty(_run.Output);
    }

    private static void AssertPlace(JsonElement point, JsonElement place)
    {
        Assert.Equal(
            [place.Number("longitudeDegrees"), place.Number("latitudeDegrees")],
            Coordinates(point).EnumerateArray().Select(e => e.GetDouble()), new Close());
        JsonElement properties = point.GetProperty("properties");
        foreach (string name in new[]
            {
                "altitudeAmslMetres", "ellipse95HalfMajorAxisMetres", "ellipse95HalfMinorAxisMetres",
                "ellipseMajorAxisDegrees",
            })
            Assert.Equal(place.Number(name), properties.Number(name), 0.006);
    }

    // On the edge of the covariance's own ellipse, against the clock, closed.
    private static void AssertEllipse(JsonElement coordinates, JsonElement place)
    {
        (double X, double Y)[] ring = Ring(coordinates);
        double[] random = place.Numbers("randomCovarianceSquareMetres");
        double[] systematic = place.Numbers("systematicCovarianceSquareMetres");
        var covariance = new HorizontalCovariance(
            random[0] + systematic[0], random[1] + systematic[1], random[2] + systematic[2]);
        var frame = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(
            place.Number("latitudeDegrees"), place.Number("longitudeDegrees"), 0));
        Assert.True(ring.Length > 30 && ring[0] == ring[ring.Length - 1] && DoubleArea(ring) > 0);
        foreach ((double longitude, double latitude) in ring)
        {
            NedPosition edge = frame.ToNed(GeodeticPosition.FromDegrees(latitude, longitude, 0));
            Assert.InRange(covariance.MahalanobisSquared(edge.North, edge.East), 5.991 * 0.98, 5.991 * 1.02);
        }
    }

    private static string KindAndGeometry(JsonElement feature)
    {
        JsonElement geometry = feature.GetProperty("geometry");
        return feature.GetProperty("properties").Text("kind") + " "
            + (geometry.ValueKind == JsonValueKind.Null ? "null" : geometry.Text("type"));
    }

    private static JsonElement Coordinates(JsonElement feature)
        => feature.GetProperty("geometry").GetProperty("coordinates");

    private static (double X, double Y)[] Ring(JsonElement ring)
        => [.. ring.EnumerateArray().Select(c => (c[0].GetDouble(), c[1].GetDouble()))];

    private static double DoubleArea((double X, double Y)[] ring)
    {
        double area = 0;
        for (int i = 0; i + 1 < ring.Length; i++)
            area += ((ring[i].X - ring[0].X) * (ring[i + 1].Y - ring[0].Y))
                - ((ring[i + 1].X - ring[0].X) * (ring[i].Y - ring[0].Y));
        return area;
    }

    private static JsonElement Root(string file) => JsonDocument.Parse(File.ReadAllText(file)).RootElement;

    private string Request(string pixels) => _run.File(
        "request.json", GeolocateFiles.Pose.Replace("\"pixel\":[319.5,239.5]", "\"pixels\":" + pixels));

    private sealed class Close : IEqualityComparer<double>
    {
        public bool Equals(double x, double y) => Math.Abs(x - y) < 1e-7;

        public int GetHashCode(double obj) => 0;
    }
}
