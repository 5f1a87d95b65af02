using System;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.CameraGeometry;

namespace VisionBench;

/// <summary>A folder of pictures with a truth.json beside them (format "uav-imagery-truth").</summary>
internal sealed class PictureSet
{
    private PictureSet(string name, ImmutableArray<ListedFrame> frames) => (Name, Frames) = (name, frames);

    public string Name { get; }

    public ImmutableArray<ListedFrame> Frames { get; }

    /// <exception cref="FormatException">It is no set of that format.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static PictureSet Load(string folder)
    {
        string path = Path.Combine(folder, "truth.json");
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(path));
            string? format = json.RootElement.GetProperty("format").GetString();
            if (!string.Equals(format, "uav-imagery-truth", StringComparison.Ordinal))
                throw new FormatException($"its format is \"{format}\"");
            var cameras = json.RootElement.GetProperty("cameras").EnumerateArray()
                .ToDictionary(c => c.GetProperty("name").GetString()!, CameraOf, StringComparer.Ordinal);
            CameraModel CameraFor(JsonElement frame) => frame.TryGetProperty("camera", out JsonElement name)
                ? cameras[name.GetString()!]
                : cameras.Values.Single();
            return new PictureSet(
                new DirectoryInfo(folder).Name,
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
