using System.IO;
using System.Text.Json;

namespace Rabit.Uav.Tests;

/// <summary>Where the recorded flights and the facts beside them are.</summary>
internal static class TestData
{
    // Not the base directory: where tests run without a domain of their own, as under Mono, that is the runner's.
    private static readonly string Folder = Path.Combine(Path.GetDirectoryName(typeof(TestData).Assembly.Location)!, "data", "mavlink");

    public static string PathOf(string file) => Path.Combine(Folder, file);

    public static JsonDocument Json(string file) => JsonDocument.Parse(File.ReadAllText(PathOf(file)));
}
