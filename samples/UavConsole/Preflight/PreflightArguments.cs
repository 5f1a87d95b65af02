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

    public static PreflightChoices Read(ParseResult result, ConfigFile? config) => new()
    {
        Overrides = result.GetValue(Override) is { Length: > 0 } names
            ? names
            : config?.Options.Preflight.Overrides ?? [],
        SetsFailsafes = result.GetValue(SetFailsafes) || config?.Options.Autopilot.Setup.SetsFailsafes == true,
        UploadsFence = result.GetValue(UploadFence) || config?.UploadsFence == true,
        OriginalsFile = result.GetValue(Originals) ?? config?.Options.Autopilot.Setup.OriginalsFile
            ?? DefaultOriginals,
        IsWithoutDetection = IsWithoutDetection(result, config),
    };

    public static bool IsWithoutDetection(ParseResult result, ConfigFile? config)
        => result.GetValue(WithoutDetection) || config?.Options.MissionControl.RequiresCamera == false;

    /// <summary>What makes no sense together.</summary>
    public static IEnumerable<string> FindFaults(ParseResult result, Given given)
    {
        (bool flies, bool hasCamera) = (given.Flies.Value, given.Camera.Value is not null);
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

        if (result.GetValue(Override) is { Length: > 0 } && !flies && !given.IsSimulated)
            yield return "--override goes with --mission FILE --fly.";
        if (flies && !given.IsSimulated && !hasCamera && !given.IsWithoutDetection)
            yield return given.Flies.Name + " needs --camera DIR: a search without pictures finds nothing; "
                + "--without-detection flies all the same.";
        if (hasCamera && result.GetValue(WithoutDetection))
            yield return "--without-detection does not go with --camera.";
    }
}
