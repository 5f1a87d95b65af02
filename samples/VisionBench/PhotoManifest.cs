using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Vision;

namespace VisionBench;

/// <summary>
/// A folder of photos with a manifest.json: "files", each with "file", "width" and "height" in pixels, and with
/// "panels_original_px" where there are panels ("centre", "quad", "size" in pixels of the original picture, which was
/// made smaller by "scale"). What a pixel is on the ground is "metres_per_pixel", or follows from the panels, which are
/// 0.4 m large, or is known of the place in the name of the file.
/// </summary>
internal static class PhotoManifest
{
    public const string FileName = "manifest.json";
    public const string PanelColour = "two-tone";

    public const double PanelSideMetres = 0.4;

    /// <summary>Of the original pictures of four flights, from their heights and focal lengths.</summary>
    public static readonly IReadOnlyDictionary<string, double> MetresPerPixelOf = new Dictionary<string, double>(
        StringComparer.Ordinal)
    {
        ["brighton"] = 0.018,
        ["caliterra"] = 0.016,
        ["seneca"] = 0.022,
        ["copr"] = 0.0033,
    };

    /// <returns>
    /// The photos whose scale is known, and how many others there are; null where the folder has no manifest of photos.
    /// </returns>
    /// <exception cref="FormatException">It has one with a fault.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static (ImmutableArray<ListedFrame> Frames, int WithoutScale)? TryLoad(string folder)
    {
        string path = Path.Combine(folder, FileName);
        if (!File.Exists(path))
            return null;
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(path));

            // A list of files, as other data have it, says nothing of photos.
            if (json.RootElement.ValueKind == JsonValueKind.Array)
                return null;
            var frames = new List<ListedFrame>();
            int all = json.RootElement.EachOf("files", (file, _) =>
            {
                if (TryRead(file, folder, frames.Count + 1) is { } frame)
                    frames.Add(frame);
                return file;
            }).Count();
            if (frames.Count == 0)
                throw new FormatException("of no picture it is known what a pixel is on the ground");
            return ([.. frames], all - frames.Count);
        }
        catch (Exception e) when (e is JsonException or FormatException)
        {
            throw new FormatException($"{path} is no manifest of photos: {e.Message}", e);
        }
    }

    private static ListedFrame? TryRead(JsonElement json, string folder, int index)
    {
        string file = json.TextOf("file");
        double scale = json.TryGetProperty("scale", out _) ? json.NumberOf("scale") : 1;
        ImmutableArray<ListedTarget> panels = json.TryGetProperty("panels_original_px", out _)
            ? [.. json.EachOf("panels_original_px", (p, _) => PanelOf(p, scale))]
            : [];
        double metresPerPixel = json.TryGetProperty("metres_per_pixel", out _)
            ? json.NumberOf("metres_per_pixel")
            : panels.Length > 0 ? PanelSideMetres / panels.Average(p => p.Size)
            : MetresPerPixelOf.Where(p => Path.GetFileName(file).Split('_').Contains(p.Key))
                .Select(p => p.Value / scale).DefaultIfEmpty(double.NaN).First();
        if (double.IsNaN(metresPerPixel))
            return null;
        if (!(metresPerPixel > 0) || double.IsInfinity(metresPerPixel))
            throw new FormatException(FormattableString.Invariant($"{file}: a pixel of {metresPerPixel} m"));
        (int Width, int Height) size = (json.WholeOf("width"), json.WholeOf("height"));
        return new ListedFrame(folder, index, file, size, metresPerPixel, panels);
    }

    private static ListedTarget PanelOf(JsonElement json, double scale)
    {
        PicturePoint PointOf(double[] point) => new(Smaller(point[0], scale), Smaller(point[1], scale));
        double[] sides = json.NumbersOf("size", 2);
        PicturePoint[] corners = [.. json.EachOf("quad", (c, _) => PointOf(
            TruthJson.Numbers(c, 2) ?? throw new FormatException("it must be a list of 2 numbers")))];
        return corners.Length == 4
            ? new ListedTarget(
                PanelColour, PointOf(json.NumbersOf("centre", 2)), corners, (sides[0] + sides[1]) / 2 * scale)
            : throw new FormatException("\"quad\" must have 4 corners");
    }

    // The middle of a pixel is a whole number.
    private static double Smaller(double value, double scale) => ((value + 0.5) * scale) - 0.5;
}
