using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Vision;

namespace VisionBench;

/// <summary>
/// A folder of pictures with markers alone: crops (format "uav-imagery-marker-crops"), photos ("files" with "tags"), or
/// the list of tests/data/markers.
/// </summary>
internal sealed class MarkerPictureSet
{
    private const string TruthFile = "truth.json";
    private const string FormatOfCrops = "uav-imagery-marker-crops";

    // Pictures of a room with the ids 0 to 20, and of cubes of NASA that all have 0: some are not listed.
    private const int MaxIdInTheRoom = 20;
    private const int IdOnTheCubes = 0;
    private const int NoId = -1;

    private MarkerPictureSet(string name, ImmutableArray<MarkerPicture> pictures)
        => (Name, Pictures) = (name, pictures);

    public string Name { get; }

    public ImmutableArray<MarkerPicture> Pictures { get; }

    /// <returns>Null where the folder is no set of this kind; it may be one of another.</returns>
    /// <exception cref="FormatException">It is one with a fault.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static MarkerPictureSet? TryLoad(string folder)
    {
        string path = Path.Combine(folder, TruthFile);
        if (!File.Exists(path))
            return null;
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(path));
            return PicturesOf(json.RootElement, folder) is { } pictures
                ? new MarkerPictureSet(new DirectoryInfo(folder).Name, [.. pictures])
                : null;
        }
        catch (Exception e)
            when (e is JsonException or FormatException)
        {
            throw new FormatException($"{path} is no truth of a picture set: {e.Message}", e);
        }
    }

    private static IEnumerable<MarkerPicture>? PicturesOf(JsonElement root, string folder)
    {
        if (root.ValueKind == JsonValueKind.Array)
            return TruthJson.Each(root, "", (p, i) => OfList(p, i + 1, folder));
        if (root.ValueKind != JsonValueKind.Object)
            return null;
        if (root.TryGetProperty("format", out JsonElement format))
            return format.ValueKind == JsonValueKind.String && format.GetString() == FormatOfCrops
                ? root.EachOf("crops", (p, i) => OfCrop(p, i + 1, folder))
                : null;
        return root.TryGetProperty("files", out _)
            ? root.EachOf("files", (p, i) => OfPhoto(p, i + 1, folder))
            : null;
    }

    private static MarkerPicture OfList(JsonElement json, int index, string folder) => Make(
        json, index, folder,
        [.. json.EachOf("markers", (m, _) => ListedMarker.Of(m, m.NumberOf("fraction_visible")))]);

    // One marker in the middle, or something that is none.
    private static MarkerPicture OfCrop(JsonElement json, int index, string folder)
    {
        JsonElement expected = json.FieldOf("expected");
        return Make(
            json, index, folder, expected.ValueKind == JsonValueKind.Object
                ? [ListedMarker.Of(expected, json.FieldOf("corners_px"))]
                : []);
    }

    private static MarkerPicture OfPhoto(JsonElement json, int index, string folder)
    {
        bool isOfCubes = json.TextOf("group") == "nasa";
        return Make(
            json, index, folder, [.. json.EachOf("tags", (t, _) => ListedMarker.OfPhoto(t))],
            json.FlagOf("complete") ? NoId : isOfCubes ? IdOnTheCubes : MaxIdInTheRoom);
    }

    private static MarkerPicture Make(
        JsonElement json, int index, string folder, ImmutableArray<ListedMarker> markers, int maxUnlistedId = NoId)
    {
        string file = json.TextOf("file");
        return new MarkerPicture(
            Path.GetFileNameWithoutExtension(file), Path.Combine(folder, file), index, markers,
            m => m.Family == MarkerFamily.AprilTag36h11 && m.Id <= maxUnlistedId);
    }
}
