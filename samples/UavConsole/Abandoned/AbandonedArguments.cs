using System.Collections.Generic;
using System.CommandLine;

namespace UavConsole;

/// <summary>The option of the mode that follows a flight which ended by a fault.</summary>
internal static class AbandonedArguments
{
    private static readonly Option<string> ReturnIfAbandoned = new("--return-if-abandoned")
    {
        Description = "After a service has failed (ExecStopPost of systemd): asks the vehicle at --link to return, "
            + "if the progress file of the flight says that it was commanded, and it is still in the air in "
            + "GUIDED of ArduPilot without a failsafe (docs/how-to.md).",
        HelpName = "FILE",
    };

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All => [ReturnIfAbandoned];

    public static string? Read(ParseResult result) => result.GetValue(ReturnIfAbandoned);

    /// <summary>What makes no sense together.</summary>
    public static IEnumerable<string> FindFaults(ParseResult result, bool hasLiveLink, bool flies)
    {
        if (result.GetValue(ReturnIfAbandoned) is null)
            yield break;
        if (!hasLiveLink)
            yield return "--return-if-abandoned needs --link URL of a live vehicle.";
        if (flies)
            yield return "--return-if-abandoned does not go with --fly.";
    }
}
