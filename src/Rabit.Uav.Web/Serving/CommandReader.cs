using System;
using System.Collections.Generic;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.Serving;

/// <summary>Reads the body of a command: what to do, with which vehicle, and what belongs to it.</summary>
internal static class CommandReader
{
    private const string Reason = "commanded in the browser";

    private static readonly Dictionary<string, OperatorCommand> Commands = new(StringComparer.Ordinal)
    {
        ["hold"] = OperatorCommand.Hold,
        ["return"] = OperatorCommand.Return,
        ["continue"] = OperatorCommand.Continue,
        ["land"] = OperatorCommand.Land,
        ["skip"] = OperatorCommand.SkipLane,
        ["revisit"] = OperatorCommand.Revisit,
        ["visit"] = OperatorCommand.RevisitPlace,
        ["confirm"] = OperatorCommand.Confirm,
        ["reject"] = OperatorCommand.Reject,
        ["speed"] = OperatorCommand.ChangeSpeed,
        ["set"] = OperatorCommand.ChangeParameter,
    };

    // Two commands in one body: none of them is meant for certain.
    private static readonly JsonDocumentOptions Options = new() { MaxDepth = 4, AllowDuplicateProperties = false };

    /// <param name="body">JSON.</param>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="vehicle">The number of the vehicle, from 0.</param>
    /// <param name="request">The command; null where there is a fault.</param>
    /// <returns>What is wrong, naming it; null where nothing is.</returns>
    public static string? Read(ReadOnlyMemory<byte> body, string by, out int vehicle, out OperatorRequest? request)
    {
        (vehicle, request) = (0, null);
        try
        {
            using JsonDocument document = JsonDocument.Parse(body, Options);
            return Read(document.RootElement, by, ref vehicle, out request);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            // The second: a text with half a surrogate pair.
            return "The body is no JSON. Nothing may be named twice in it.";
        }
    }

    private static string? Read(JsonElement body, string by, ref int vehicle, out OperatorRequest? request)
    {
        request = null;
        if (body.ValueKind != JsonValueKind.Object)
            return "The body is no JSON object.";
        if (!body.TryGetProperty("command", out JsonElement name) || name.ValueKind != JsonValueKind.String
            || !Commands.TryGetValue(name.GetString()!, out OperatorCommand command))
            return "command: it must be one of " + string.Join(", ", Commands.Keys) + ".";
        if (body.TryGetProperty("vehicle", out JsonElement number) && !TryGetInt(number, out vehicle))
            return "vehicle: it must be a number from 0.";
        switch (command)
        {
            case OperatorCommand.Revisit or OperatorCommand.Confirm or OperatorCommand.Reject:
                if (!body.TryGetProperty("track", out JsonElement track) || !TryGetInt(track, out int id))
                    return "track: it must be the number of a track.";
                request = new OperatorRequest(command, by, Reason) { TrackId = id };
                return null;
            case OperatorCommand.RevisitPlace:
                if (!TryGetNumber(body, "latitude", 90, out double lat)
                    || !TryGetNumber(body, "longitude", 180, out double lon))
                    return "latitude, longitude: they must be degrees.";
                request = new OperatorRequest(command, by, Reason)
                {
                    Place = GeodeticPosition.FromDegrees(lat, lon, 0),
                };
                return null;
            case OperatorCommand.ChangeSpeed:
                if (!TryGetNumber(body, "metresPerSecond", 1000, out double speed))
                    return "metresPerSecond: it must be a number.";
                request = new OperatorRequest(command, by, Reason) { SpeedMetresPerSecond = speed };
                return null;
            case OperatorCommand.ChangeParameter:
                return ReadParameter(body, by, out request);
            default:
                request = new OperatorRequest(command, by, Reason);
                return null;
        }
    }

    private static string? ReadParameter(JsonElement body, string by, out OperatorRequest? request)
    {
        request = null;
        if (!body.TryGetProperty("parameter", out JsonElement name) || name.ValueKind != JsonValueKind.String
            || !Enum.TryParse(name.GetString(), out MissionParameter parameter)
            || Enum.GetName(parameter) != name.GetString())
            return "parameter: it must be one of " + string.Join(", ", Enum.GetNames<MissionParameter>()) + ".";
        if (!TryGetNumber(body, "value", 1e9, out double value))
            return "value: it must be a number.";
        request = new OperatorRequest(OperatorCommand.ChangeParameter, by, Reason)
        {
            Parameter = parameter,
            Value = value,
        };
        return null;
    }

    private static bool TryGetInt(JsonElement element, out int value)
    {
        value = 0;
        return element.ValueKind == JsonValueKind.Number && element.TryGetInt32(out value) && value >= 0;
    }

    private static bool TryGetNumber(JsonElement body, string name, double limit, out double value)
    {
        value = 0;
        return body.TryGetProperty(name, out JsonElement element) && element.ValueKind == JsonValueKind.Number
            && element.TryGetDouble(out value) && Math.Abs(value) <= limit;
    }
}
