using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Uav.Links;

namespace UavConsole;

/// <summary>Reads the command line. Everything wrong with it is one line and exit code 2.</summary>
internal static class CommandLine
{
    private const string BundledFlight = "flights/ardupilot-flight.tlog";

    public static RootCommand Create(Func<ConsoleOptions, int> run)
    {
        var links = new Option<LinkUrl[]>("--link", "-l")
        {
            Description = "udpin:ADDRESS:PORT, udpout:HOST:PORT, tcp:HOST:PORT, serial:DEVICE:BAUD or tlog:FILE[?speed=10|max]; may be given several times. "
                + "Without it a bundled recorded flight is replayed at 10 times its pace.",
            HelpName = "URL",
            CustomParser = ParseLinks,
            AllowMultipleArgumentsPerToken = false,
        };
        var headless = new Option<bool>("--headless") { Description = "Plain lines instead of a live screen; by itself where the output is no terminal." };
        var summary = new Option<string>("--summary") { Description = "Writes the summary as JSON too (docs/uavconsole-summary.md).", HelpName = "FILE" };
        var systemId = new Option<byte?>("--system-id")
        {
            Description = "Our MAVLink system id, 1 to 255, and so that of the vehicle that carries us; without it that of the first autopilot heard.",
            HelpName = "N",
            CustomParser = ParseSystemId,
        };

        var command = new RootCommand("Rabit's managers on a flight: a recorded one, or a live autopilot. It observes; it commands nothing.") { links, headless, summary, systemId };
        command.SetAction(result => run(new ConsoleOptions(
            result.GetValue(links) is { Length: > 0 } given ? given : [BundledLink()],
            result.GetValue(headless) || !LiveScreen.IsPossible(),
            result.GetValue(summary),
            result.GetValue(systemId))));
        return command;
    }

    private static LinkUrl[] ParseLinks(ArgumentResult result)
    {
        var urls = new List<LinkUrl>();
        foreach (string text in result.Tokens.Select(t => t.Value))
        {
            if (LinkUrl.TryParse(text, out LinkUrl? url, out string? error))
                urls.Add(url!);
            else
                result.AddError(error!);
        }

        return urls.ToArray();
    }

    private static byte? ParseSystemId(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (byte.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out byte id) && id != 0)
            return id;
        result.AddError($"--system-id {text}: it must be a number from 1 to 255.");
        return null;
    }

    private static LinkUrl BundledLink() => LinkUrl.Parse($"tlog:{Path.Combine(AppContext.BaseDirectory, BundledFlight)}?speed=10");
}
