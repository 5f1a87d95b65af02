using System.IO;
using System.Text.Json;

namespace Rabit.Uav.Tests;

/// <summary>Where the recorded flights and the facts beside them are.</summary>
internal static class TestData
{
    // Not the base directory: where tests run without a domain of their own, as under Mono, that is the runner's.
    private static readonly string Data = Path.Combine(
        Path.GetDirectoryName(typeof(TestData).Assembly.Location)!, "data");

    public static string Folder => Data;

    public static string PathOf(string file) => Path.Combine(Data, "mavlink", file);

    public static string MissionText(string file) => File.ReadAllText(Path.Combine(Data, "missions", file));

    public static string AutopilotPathOf(string file) => Path.Combine(Data, "autopilots", file);

    public static JsonDocument Autonomy(string file)
        => JsonDocument.Parse(File.ReadAllText(Path.Combine(Data, "autonomy", file)));

    public static string TrackingPathOf(string file) => Path.Combine(Data, "autonomy", "ru-mtt-1", file);

    public static JsonDocument Json(string file) => JsonDocument.Parse(File.ReadAllText(PathOf(file)));
}
