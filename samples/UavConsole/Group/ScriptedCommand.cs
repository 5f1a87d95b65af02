using System;
using System.Globalization;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>A command that the ground station of a simulated group gives when the command line says.</summary>
/// <param name="At">When, by the clock of the group.</param>
/// <param name="Vehicle">The system id of the vehicle; 0 for all.</param>
/// <param name="Command">What.</param>
/// <param name="TrackId">Of which track; 0 for none.</param>
/// <param name="Text">As it was written.</param>
internal sealed record ScriptedCommand(TimeSpan At, byte Vehicle, OperatorCommand Command, int TrackId, string Text)
{
    /// <summary>How one is written.</summary>
    public const string Form = "SECONDS:VEHICLE:COMMAND with the system id of the vehicle or all, and hold, continue, "
        + "return, land, skip, or for one vehicle, by its number of the track, revisit=TRACK, confirm=TRACK or "
        + "reject=TRACK";

    private const double MaxSeconds = 86_400;
    private const int MaxTrack = 1_000_000;

    /// <summary>Reads one.</summary>
    /// <returns>Null where the text is none.</returns>
    public static ScriptedCommand? TryParse(string text)
    {
        string[] parts = text.Split(':');
        if (parts.Length != 3
            || !double.TryParse(
                parts[0], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double seconds)
            || !(seconds <= MaxSeconds)) // not a number neither
            return null;
        byte vehicle = 0;
        if (parts[1] != "all"
            && (!byte.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out vehicle) || vehicle == 0))
            return null;
        string[] words = parts[2].Split('=');
        OperatorCommand? command = words[0] switch
        {
            "hold" => OperatorCommand.Hold,
            "continue" => OperatorCommand.Continue,
            "return" => OperatorCommand.Return,
            "land" => OperatorCommand.Land,
            "skip" => OperatorCommand.SkipLane,
            "revisit" => OperatorCommand.Revisit,
            "confirm" => OperatorCommand.Confirm,
            "reject" => OperatorCommand.Reject,
            _ => null,
        };
        bool isOfTrack = command is OperatorCommand.Revisit or OperatorCommand.Confirm or OperatorCommand.Reject;
        int track = 0;
        bool hasTrack = words.Length == 2
            && int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out track)
            && track is >= 1 and <= MaxTrack;

        // Each vehicle numbers its tracks itself.
        bool isPossible = isOfTrack ? hasTrack && vehicle != 0 : words.Length == 1;
        return command is { } given && isPossible
            ? new ScriptedCommand(TimeSpan.FromSeconds(seconds), vehicle, given, track, text)
            : null;
    }
}
