using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Vision.Tests;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Tool.Tests.Geolocate;

/// <summary>
/// Photos of drones, from their metadata alone: a point that two of them show must have one place. The photos are
/// smaller copies with the metadata of the originals.
/// </summary>
public sealed class RealPhotoTests(ITestOutputHelper output) : IDisposable
{
    private readonly GeolocateFiles _run = new();

    public void Dispose() => _run.Dispose();

    [RealPicturesFact("aerial")]
    public void Pixel_OfAPairOfPhotos_HasOnePlaceByTheMetadataAlone()
    {
        (double median, double p90, double inside) = Measure("brighton");
        Assert.InRange(median, 0, 2.3);
        Assert.InRange(p90, 0, 5.0);
        Assert.InRange(inside, 0.90, 0.99);

        (median, p90, inside) = Measure("minsk");
        Assert.InRange(median, 0, 6.6);
        Assert.InRange(p90, 0, 10.5);
        Assert.InRange(inside, 0.90, 0.99);
    }

    [RealPicturesFact("aerial")]
    public void Pixel_OfAPairOfPhotos_WithTheSensor()
    {
        string[] sensor = ["--sensor-width", "6.17"];
        Assert.InRange(Measure("brighton", sensor).Median, 0, 2.0);
        Assert.InRange(Measure("minsk", sensor).Median, 0, 3.5);
    }

    [RealPicturesFact("aerial")]
    public void Pixel_InTheMiddle_IsWhereTheLaserHits()
    {
        string photo = Path.Combine(
            RealPicturesFactAttribute.FolderOf("aerial")!, "originals", "thermal_H20N_DJI_0006_R.jpg");
        var target = GeodeticPosition.FromDegrees(22.5960255, 114.0066452, 47.0);

        Assert.Equal(0, _run.Run(photo, "--pixel", "319.5,255.5", "--json"));
        double alone = Distance(_run.Place, target);
        Assert.Equal(0, _run.Run(photo, "--pixel", "319.5,255.5", "--json", "--ground-altitude", "47"));
        double withGround = Distance(_run.Place, target);

        output.WriteLine(FormattableString.Invariant(
            $"{alone:0.00} m, with the ground's altitude {withGround:0.00} m"));
        Assert.InRange(alone, 0, 1);
        Assert.InRange(withGround, 0, 0.5);
    }

    private static double Distance(GeodeticPosition a, GeodeticPosition b)
    {
        NedPosition ned = LocalNedFrame.IgnoringGeoid(a).ToNed(b);
        return Math.Sqrt((ned.North * ned.North) + (ned.East * ned.East));
    }

    private (double Median, double P90, double Inside) Measure(string set, params string[] options)
    {
        string folder = RealPicturesFactAttribute.FolderOf("aerial")!;
        using JsonDocument pairs = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "pairs.json")));
        using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "manifest.json")));
        HashSet<string> turned =
        [
            .. manifest.RootElement.Each("files")
                .Where(f => f.TryGetProperty("pixels_turned_180_vs_metadata", out JsonElement t) && t.GetBoolean())
                .Select(f => f.Text("file")!),
        ];
        var distances = new List<double>();
        int inside = 0;
        foreach (JsonElement pair in pairs.RootElement.Each("pairs").Where(p => p.Text("set") == set))
        {
            foreach (JsonElement point in pair.Each("points"))
            {
                double[] p = [.. point.EnumerateArray().Select(n => n.GetDouble())];
                (GeodeticPosition placeA, double[] a) = Locate(set, pair.Text("a")!, p[0], p[1], turned, options);
                (GeodeticPosition placeB, double[] b) = Locate(set, pair.Text("b")!, p[2], p[3], turned, options);
                NedPosition d = LocalNedFrame.IgnoringGeoid(placeA).ToNed(placeB);
                distances.Add(Math.Sqrt((d.North * d.North) + (d.East * d.East)));
                (double nn, double ne, double ee) = (a[0] + b[0], a[1] + b[1], a[2] + b[2]);
                double mahalanobis = ((ee * d.North * d.North) - (2 * ne * d.North * d.East) + (nn * d.East * d.East))
                    / ((nn * ee) - (ne * ne));
                inside += mahalanobis < 5.991 ? 1 : 0;
            }
        }

        distances.Sort();
        (double median, double p90, double part) = (
            distances[distances.Count / 2], distances[distances.Count * 9 / 10], (double)inside / distances.Count);
        output.WriteLine(FormattableString.Invariant(
            $"{set} {string.Join(" ", options)}: {distances.Count} points, median {median:0.00} m, p90 {p90:0.00} m, {part:P1} inside"));
        return (median, p90, part);
    }

    private (GeodeticPosition Place, double[] Covariance) Locate(
        string set, string name, double column, double row, HashSet<string> turned, string[] options)
    {
        const double Scale = 0.25;
        string file = $"small/{set}_{Path.GetFileNameWithoutExtension(name)}_s.jpg";
        string pixel = string.Format(
            CultureInfo.InvariantCulture, "{0},{1}", ((column + 0.5) * Scale) - 0.5, ((row + 0.5) * Scale) - 0.5);
        string path = Path.Combine(RealPicturesFactAttribute.FolderOf("aerial")!, file);
        string[] turn = turned.Contains(file) ? ["--turned"] : [];
        string[] all = [path, "--pixel", pixel, "--json", .. turn, .. options];
        Assert.True(_run.Run(all) == 0, _run.Errors + _run.Output);
        double[] random = _run.Json.Numbers("randomCovarianceSquareMetres");
        double[] systematic = _run.Json.Numbers("systematicCovarianceSquareMetres");
        return (_run.Place, [.. random.Zip(systematic, (r, s) => r + s)]);
    }
}
