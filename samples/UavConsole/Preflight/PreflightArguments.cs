using System.Collections.Generic;
using System.CommandLine;

namespace UavConsole;

/// <summary>The options of the checklist and of what is written to the autopilot before a flight.</summary>
internal static class PreflightArguments
{
    /// <summary>Where the autopilot's own values are kept when nothing else is asked for.</summary>
    public const string DefaultOriginals = "autopilot-originals.json";

    private static readonly Option<string[]> Override = new("--override")
    {
        Description = "A line of the pre-flight checklist that may fail, by its name (docs/preflight.md); may be given "
            + "several times.",
        HelpName = "NAME",
        AllowMultipleArgumentsPerToken = false,
    };

    private static readonly Option<bool> SetFailsafes = new("--set-failsafes")
    {
        Description = "Sets the autopilot's failsafe parameters that do not pass the checklist, and writes its own "
            + "values back after the flight, on the ground; needs --fly.",
    };

    private static readonly Option<bool> UploadFence = new("--upload-fence")
    {
        Description = "Uploads the mission's area and a margin as the autopilot's fence; the fence that it has is "
            + "written back after the flight; needs --fly.",
    };

    private static readonly Option<string> Originals = new("--originals")
    {
        Description = "Where the autopilot's own values are kept until they are written back. "
            + $"{DefaultOriginals} without it; needs --fly.",
        HelpName = "FILE",
    };

    private static readonly Option<bool> WithoutDetection = new("--without-detection")
    {
        Description = "Flies the mission without a camera; --fly needs --camera otherwise.",
    };

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All => [Override, SetFailsafes, UploadFence, Originals, WithoutDetection];

    public static PreflightChoices Read(ParseResult result) => new()
    {
        Overrides = result.GetValue(Override) ?? [],
        SetsFailsafes = result.GetValue(SetFailsafes),
        UploadsFence = result.GetValue(UploadFence),
        OriginalsFile = result.GetValue(Originals) ?? DefaultOriginals,
        IsWithoutDetection = result.GetValue(WithoutDetection),
    };

    /// <summary>What makes no sense together.</summary>
    public static IEnumerable<string> FindFaults(ParseResult result, bool flies, bool isSimulated, bool hasCamera)
    {
        foreach ((string name, bool isGiven) in new[]
        {
            ("--set-failsafes", result.GetValue(SetFailsafes)), ("--upload-fence", result.GetValue(UploadFence)),
            ("--originals", result.GetValue(Originals) is not null),
            ("--without-detection", result.GetValue(WithoutDetection)),
        })
        {
            if (isGiven && !flies)
                yield return $"{name} goes with --mission FILE --fly.";
        }

        if (result.GetValue(Override) is { Length: > 0 } && !flies && !isSimulated)
            yield return "--override goes with --mission FILE --fly.";
        if (flies && !isSimulated && !hasCamera && !result.GetValue(WithoutDetection))
            yield return "--fly needs --camera DIR: a search without pictures finds nothing; --without-detection flies "
                + "all the same.";
        if (hasCamera && result.GetValue(WithoutDetection))
            yield return "--without-detection does not go with --camera.";
    }
}
