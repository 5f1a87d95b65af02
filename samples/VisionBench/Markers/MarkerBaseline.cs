using System.Globalization;
using System.IO;
using System.Text.Json;

namespace VisionBench;

/// <summary>
/// The figures of the reference for the markers of one set, as text: OpenCV with settings for small markers, which find
/// the most.
/// </summary>
internal sealed class MarkerBaseline
{
    private const string Setting = "small-marker";

    private MarkerBaseline(JsonElement json)
    {
        Found = $"{json.GetProperty("found").GetInt32()}/{json.GetProperty("of").GetInt32()}";
        Wrong = json.GetProperty("wrong_ids").GetInt32().ToString(CultureInfo.InvariantCulture);
        CornerRms = json.GetProperty("corner_rms_px").GetDouble().ToString("0.00", CultureInfo.InvariantCulture);
    }

    public string Found { get; }

    public string Wrong { get; }

    public string CornerRms { get; }

    /// <summary>Null where there is none beside the set.</summary>
    public static MarkerBaseline? Load(string folder)
    {
        var set = new DirectoryInfo(folder);
        string path = Path.Combine(set.Parent?.FullName ?? ".", "baseline.json");
        if (!File.Exists(path))
            return null;
        using var json = JsonDocument.Parse(File.ReadAllText(path));
        if (!json.RootElement.GetProperty("sets").TryGetProperty(set.Name, out JsonElement figures))
            return null;
        if (figures.TryGetProperty("markers", out JsonElement markers))
            figures = markers;
        return figures.TryGetProperty(Setting, out JsonElement found) ? new MarkerBaseline(found) : null;
    }
}
