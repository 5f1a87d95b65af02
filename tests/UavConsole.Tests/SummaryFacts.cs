using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.Tests;

namespace UavConsole.Tests;

/// <summary>What a summary lists, in the words of <see cref="SidecarFacts"/>.</summary>
internal static class SummaryFacts
{
    private static readonly (string Name, string Key)[] RangeNames =
    [
        ("lat", "latitudeDegE7"), ("lon", "longitudeDegE7"), ("alt", "altitudeAmslMillimetres"),
        ("relative_alt", "heightAboveHomeMillimetres"),
    ];

    public static IEnumerable<string> ModeChanges(JsonElement summary)
        => summary.GetProperty("modeChanges").EnumerateArray()
            .Select(e => SidecarFacts.Line(
                Number(e, "record"), Number(e, "utcMicroseconds"), Number(e, "customMode"), Number(e, "baseMode"),
                e.GetProperty("armed").GetBoolean(), Number(e, "systemStatus")));

    public static IEnumerable<string> Acknowledgements(JsonElement summary)
        => summary.GetProperty("commandAcknowledgements").EnumerateArray()
            .Select(e => SidecarFacts.Line(
                Number(e, "record"), Number(e, "utcMicroseconds"), Number(e, "command"), Number(e, "result"),
                Number(e, "progressPercent"),
                Number(e, "resultParam2"), Number(e, "targetSystemId"), Number(e, "targetComponentId")));

    public static IEnumerable<string> Texts(JsonElement summary) => summary.GetProperty("statusTexts").EnumerateArray()
        .Select(e => SidecarFacts.Line(
            Number(e, "record"), Number(e, "utcMicroseconds"), Number(e, "systemId"), Number(e, "componentId"),
            Number(e, "severity"), e.GetProperty("text").GetString()!));

    public static IEnumerable<string> Ranges(JsonElement summary) => RangeNames.Select(r =>
    {
        JsonElement range = summary.GetProperty("globalPositionInt").GetProperty(r.Key);
        return SidecarFacts.Line(r.Name, Number(range, "min"), Number(range, "max"));
    });

    private static long Number(JsonElement element, string name) => element.GetProperty(name).GetInt64();
}
