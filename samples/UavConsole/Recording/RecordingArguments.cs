using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;

namespace UavConsole;

/// <summary>The options of the recording of the links.</summary>
internal static class RecordingArguments
{
    private const int MaxMegabytes = 1_000_000;

    private static readonly Option<bool> NoTlog = new("--no-tlog")
    {
        Description = "Records nothing. Without it all that comes in and goes out over a live link is written to "
            + "MISSION-DATE.tlog, flight-DATE.tlog where no mission is flown, which --link tlog:FILE plays again."
    };

    private static readonly Option<string?> Folder = new("--tlog-dir")
    {
        Description = "Where the recording goes, the current folder without it; a simulated flight is recorded with "
            + "it only.",
        HelpName = "DIR",
    };

    private static readonly Option<long?> Size = new("--tlog-size")
    {
        Description = $"How large a file of the recording becomes before the next is begun, 1 to {MaxMegabytes} MB; 256 "
            + "without it. 16 files are kept of one run.",
        HelpName = "MB",
        CustomParser = ParseSize,
    };

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All => [NoTlog, Folder, Size];

    public static RecordingChoices Read(ParseResult result, ConfigFile? config) => new()
    {
        Configured = config?.Options.Communications.Recording,
        IsWanted = result.GetValue(NoTlog) ? false : result.GetValue(Folder) is not null ? true : null,
        Folder = result.GetValue(Folder),
        MaxFileBytes = result.GetValue(Size),
    };

    public static IEnumerable<string> FindFaults(ParseResult result, bool isReplay)
    {
        (string Name, bool IsGiven)[] all =
        [
            (Folder.Name, result.GetValue(Folder) is not null), (Size.Name, result.GetValue(Size) is not null),
        ];
        string[] given = all.Where(o => o.IsGiven).Select(o => o.Name).ToArray();
        if (given.Length == 0)
            yield break;
        string options = string.Join(" and ", given);
        if (result.GetValue(NoTlog))
            yield return $"{options} and --no-tlog contradict each other.";
        if (isReplay)
            yield return $"{options} needs a live link or the simulation: what is played is recorded already.";
    }

    private static long? ParseSize(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int megabytes)
            && megabytes is >= 1 and <= MaxMegabytes)
            return megabytes * 1_000_000L;
        result.AddError($"--tlog-size {text}: it must be a number of megabytes from 1 to {MaxMegabytes}.");
        return null;
    }
}
