using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Tool.TelemetryLogs;

namespace Rabit.Tool.Commands;

/// <summary><c>rabit mavlink</c>: what is in a telemetry log.</summary>
internal static class MavlinkLogCommand
{
    /// <summary>Ids are three bytes on the wire.</summary>
    private const int MaxMessageId = 0xFF_FFFF;

    public static Command Create()
    {
        var file = new Argument<string>("FILE") { Description = "The telemetry log (.tlog)." };
        var messages = new Option<int[]>("--message", "-m")
        {
            Description =
                "Only this message, by name or id; may be given several times. Without --csv or --json: one line each.",
            HelpName = "NAME",
            CustomParser = ParseMessages,
            AllowMultipleArgumentsPerToken = false,
        };
        messages.CompletionSources.Add(context => MavlinkDialect.All.Messages.Select(message => message.Name)
            .Where(name => name.StartsWith(context.WordToComplete, StringComparison.OrdinalIgnoreCase)));
        Option<byte?> system = IdOption("--system", "Only what this system sent, 1 to 255.");
        Option<byte?> component = IdOption("--component", "Only what this component sent, 1 to 255.");
        var print = new Option<bool>("--print") { Description = "One line for each message instead of the table." };
        var csv = new Option<bool>("--csv")
        {
            Description = "Comma-separated values of one message: time, sender, then its fields in a column each."
        };
        var json = new Option<bool>("--json")
        {
            Description = "One JSON object for each message, on a line of its own."
        };

        var events = new Option<string>("--px4-events")
        {
            Description = "The texts of PX4's events: all_events.json of its build. They stand behind the fields.",
            HelpName = "FILE",
        };

        var command = new Command(
            "mavlink",
            "Shows what is in a MAVLink telemetry log: a table of messages and senders, or the messages themselves.")
            { file, messages, system, component, print, csv, json, events };
        CommandLine.CheckFileName(file, command);
        command.Validators.Add(result =>
        {
            if (new[] { print, csv, json }.Count(option => result.GetValue(option)) > 1)
                result.AddError("--print, --csv and --json exclude each other.");
            else if (result.GetValue(csv) && result.GetResult(messages)?.Tokens.Count != 1)
                result.AddError("--csv needs exactly one --message, since each has columns of its own.");
        });
        command.SetAction(result => DumpRun.Run(new DumpOptions(
            result.GetValue(file)!,
            FormatOf(result.GetValue(print), result.GetValue(csv), result.GetValue(json), result.GetValue(messages)),
            result.GetValue(messages) ?? [],
            result.GetValue(system),
            result.GetValue(component),
            result.GetValue(events)), result.InvocationConfiguration.Error));
        return command;
    }

    private static DumpFormat FormatOf(bool print, bool csv, bool json, int[]? messages) =>
        csv ? DumpFormat.Csv
            : json ? DumpFormat.Json
            : print || messages is { Length: > 0 } ? DumpFormat.Lines
            : DumpFormat.Table;

    private static int[] ParseMessages(ArgumentResult result)
    {
        var ids = new List<int>();
        foreach (string text in result.Tokens.Select(token => token.Value))
        {
            if (MavlinkDialect.All.TryGetMessage(text, out MavlinkMessageInfo message))
                ids.Add(message.Id);
            else if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int id)
                && id <= MaxMessageId)
                ids.Add(id);
            else
                result.AddError($"--message {text}: no message of that name{Similar(text)}");
        }

        return ids.ToArray();
    }

    private static string Similar(string text)
    {
        List<string> names = MavlinkDialect.All.Messages.Select(message => message.Name)
            .Where(name => text.Length > 2
                && CultureInfo.InvariantCulture.CompareInfo.IndexOf(name, text, CompareOptions.OrdinalIgnoreCase) >= 0)
            .OrderBy(name => name.Length).ThenBy(name => name, StringComparer.Ordinal).Take(5).ToList();
        return names.Count == 0 ? "." : "; did you mean " + string.Join(", ", names) + "?";
    }

    private static Option<byte?> IdOption(string name, string description) => new(name)
    {
        Description = description,
        HelpName = "N",
        CustomParser = result =>
        {
            string text = result.Tokens[0].Value;
            if (byte.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out byte id) && id != 0)
                return id;
            result.AddError($"{name} {text}: it must be a number from 1 to 255.");
            return null;
        },
    };
}
