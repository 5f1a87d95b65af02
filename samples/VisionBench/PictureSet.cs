using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace VisionBench;

/// <summary>
/// A folder of pictures with a truth.json beside them (format "uav-imagery-truth"), or of photos (<see
/// cref="PhotoManifest"/>).
/// </summary>
internal sealed class PictureSet
{
    private const string TruthFile = "truth.json";
    private const string TruthFormat = "uav-imagery-truth";
    private const string WhatIsExpected =
        $"A set is a folder with a {TruthFile} (format {TruthFormat}), or a {PhotoManifest.FileName} of photos, and the "
        + "pictures that it lists.";

    private PictureSet(
        string folder, ImmutableArray<TargetClass> classes, ImmutableArray<ListedFrame> frames, int withoutScale = 0)
    {
        (Name, Classes, Frames) = (new DirectoryInfo(folder).Name, classes, frames);
        WithoutScale = withoutScale;
    }

    public string Name { get; }

    /// <summary>What the pictures are searched for.</summary>
    public ImmutableArray<TargetClass> Classes { get; }

    public ImmutableArray<ListedFrame> Frames { get; }

    /// <summary>Pictures in the list that are not searched, since nothing says what a pixel is on the ground.</summary>
    public int WithoutScale { get; }

    /// <exception cref="FormatException">It is no set of that format.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static PictureSet Load(string folder)
    {
        string path = Path.Combine(folder, TruthFile);
        if (!File.Exists(path) && PhotoManifest.TryLoad(folder) is { } photos)
            return new PictureSet(folder, BenchClasses.BlackAndWhitePanels, photos.Frames, photos.WithoutScale);
        if (!File.Exists(path))
            throw new FormatException($"{folder}: {FaultOf(folder)}. {WhatIsExpected}");
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(path));
            if (json.RootElement.TextOf("format") is var format && format != TruthFormat)
                throw new FormatException($"its format is \"{format}\", not \"{TruthFormat}\"");
            var cameras = new Dictionary<string, CameraModel>(StringComparer.Ordinal);
            foreach ((string name, CameraModel camera) in json.RootElement.EachOf("cameras", CameraOf))
            {
                if (cameras.ContainsKey(name))
                    throw new FormatException($"\"cameras\" has {name} twice");
                cameras.Add(name, camera);
            }

            ImmutableArray<ListedFrame> frames = [.. json.RootElement.EachOf(
                "frames", (f, i) => new ListedFrame(folder, i + 1, f, CameraFor(f, cameras)))];
            return frames.IsEmpty
                ? throw new FormatException("\"frames\" is empty")
                : new PictureSet(folder, BenchClasses.All, frames);
        }
        catch (Exception e) when (e is JsonException or FormatException)
        {
            throw new FormatException($"{path} is no truth of a picture set: {e.Message}", e);
        }
    }

    private static string FaultOf(string folder)
    {
        if (!Directory.Exists(folder))
            return File.Exists(folder) ? "it is a file, not a folder" : "there is no such folder";
        string[] inside = [.. Directory.GetDirectories(folder)
            .Where(f => File.Exists(Path.Combine(f, TruthFile))).Select(f => Path.GetFileName(f)!)
            .OrderBy(f => f, StringComparer.Ordinal)];
        string others = inside.Length > 0 ? ", but these in it do: " + string.Join(", ", inside) : "";
        return $"it has no {TruthFile}{others}";
    }

    private static CameraModel CameraFor(JsonElement frame, Dictionary<string, CameraModel> cameras)
    {
        if (!frame.TryGetProperty("camera", out _))
        {
            return cameras.Count == 1
                ? cameras.Values.Single()
                : throw new FormatException($"\"camera\" is missing, and there are {cameras.Count} cameras");
        }

        string name = frame.TextOf("camera");
        return cameras.TryGetValue(name, out CameraModel? camera)
            ? camera
            : throw new FormatException($"\"camera\" is {name}, which is not in \"cameras\"");
    }

    private static (string Name, CameraModel Camera) CameraOf(JsonElement json, int index)
    {
        double[] lens = json.NumbersOf("dist_k1_k2_p1_p2_k3", 5);
        var camera = new CameraModel
        {
            Width = json.WholeOf("width"),
            Height = json.WholeOf("height"),
            FocalX = json.NumberOf("fx"),
            FocalY = json.NumberOf("fy"),
            CentreX = json.NumberOf("cx"),
            CentreY = json.NumberOf("cy"),
            K1 = lens[0],
            K2 = lens[1],
            P1 = lens[2],
            P2 = lens[3],
            K3 = lens[4],
        };
        if (RgbPicture.FindSizeFault(camera.Width, camera.Height) is { } fault)
            throw new FormatException(fault);
        return camera.FocalX > 0 && camera.FocalY > 0
            ? (json.TextOf("name"), camera)
            : throw new FormatException("\"fx\" and \"fy\" must be above 0");
    }
}
