using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Linq;

namespace UavConsole;

/// <summary>The options of the live page.</summary>
internal static class WebArguments
{
    private static readonly Option<string?> Web = new("--web")
    {
        Description = "Shows the flight in browsers while it lasts (docs/concepts/live-page.md), at 127.0.0.1:8080 without "
            + "an address; any other than loopback needs --web-token. A simulation goes with --realtime. Not under "
            + "Mono.",
        HelpName = "ADDRESS:PORT",
        Arity = ArgumentArity.ZeroOrOne,
    };

    private static readonly Option<string?> Token = new("--web-token")
    {
        Description = "The token by which browsers may command the mission, the first line of a file: 16 to 256 "
            + "characters. Without it they only watch.",
        HelpName = "FILE",
    };

    private static readonly Option<string?> Tiles = new("--web-tiles")
    {
        Description = "A folder of map tiles, ZOOM/X/Y.png, drawn below the map of the live page.",
        HelpName = "DIR",
    };

    private static readonly Option<string[]> Hosts = new("--web-host")
    {
        Description = "A name by which browsers may reach the live page, beside that of this computer; may be given "
            + "several times.",
        HelpName = "NAME",
    };

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All => [Web, Token, Tiles, Hosts];

    /// <returns>Null where no page is asked for.</returns>
    public static WebChoices? Read(ParseResult result) => !IsGiven(result, Web) ? null : new WebChoices
    {
        Address = result.GetValue(Web),
        TokenFile = result.GetValue(Token),
        TileFolder = result.GetValue(Tiles),
        HostNames = result.GetValue(Hosts) ?? [],
    };

    public static IEnumerable<string> FindFaults(ParseResult result)
    {
        if (Read(result) is { } choices)
            return WebView.FindFault(choices) is { } fault ? [fault] : [];
        return new Option[] { Token, Tiles, Hosts }.Where(o => IsGiven(result, o))
            .Select(o => $"{o.Name} goes with --web.");
    }

    private static bool IsGiven(ParseResult result, Option option) => result.GetResult(option) is { Implicit: false };
}
