using System;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

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
            foreach (string part in (string[])["format", "cameras", "frames"])
            {
                if (!json.RootElement.TryGetProperty(part, out JsonElement value))
                    throw new FormatException($"\"{part}\" is missing");
                if (part == "format" && value.GetString() != TruthFormat)
                    throw new FormatException($"its format is \"{value.GetString()}\", not \"{TruthFormat}\"");
            }

            var cameras = json.RootElement.GetProperty("cameras").EnumerateArray()
                .ToDictionary(c => c.GetProperty("name").GetString()!, CameraOf, StringComparer.Ordinal);
            CameraModel CameraFor(JsonElement frame) => frame.TryGetProperty("camera", out JsonElement name)
                ? cameras[name.GetString()!]
                : cameras.Values.Single();
            return new PictureSet(
                folder,
                BenchClasses.All,
                json.RootElement.GetProperty("frames").EnumerateArray()
                    .Select((f, i) => new ListedFrame(folder, i + 1, f, CameraFor(f)))
                    .ToImmutableArray());
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException
            or System.Collections.Generic.KeyNotFoundException or FormatException)
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

    private static CameraModel CameraOf(JsonElement json)
    {
        JsonElement lens = json.GetProperty("dist_k1_k2_p1_p2_k3");
        return new CameraModel
        {
            Width = json.GetProperty("width").GetInt32(),
            Height = json.GetProperty("height").GetInt32(),
            FocalX = json.GetProperty("fx").GetDouble(),
            FocalY = json.GetProperty("fy").GetDouble(),
            CentreX = json.GetProperty("cx").GetDouble(),
            CentreY = json.GetProperty("cy").GetDouble(),
            K1 = lens[0].GetDouble(),
            K2 = lens[1].GetDouble(),
            P1 = lens[2].GetDouble(),
            P2 = lens[3].GetDouble(),
            K3 = lens[4].GetDouble(),
        };
    }
}
