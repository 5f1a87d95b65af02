using System.IO;

namespace UavConsole.Tests;

/// <summary>A mission of one lane, for flights of which the search is not the point: a minute and a half.</summary>
internal static class SmallMission
{
    private const string Text =
        """
        {
          "name": "small",
          "area": [[47.3972, 8.5446], [47.3974, 8.5446], [47.3974, 8.5450], [47.3972, 8.5450]],
          "heightMetres": 20, "speedMetresPerSecond": 6, "laneSpacingMetres": 24,
          "targets": ["red"]
        }
        """;

    /// <returns>The name of the file in the folder.</returns>
    public static string WriteTo(string folder)
    {
        File.WriteAllText(Path.Combine(folder, "small.json"), Text);
        return "small.json";
    }
}
