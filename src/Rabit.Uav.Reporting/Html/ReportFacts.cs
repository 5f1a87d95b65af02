using System;
using System.Globalization;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>Under the title of the page: when, with what and by whom it was flown.</summary>
internal sealed class ReportFacts(PageWriter page, FlightSummary data)
{
    private const int HashDigitsShown = 16;

    public void Write()
    {
        page.Open("dl", "class", "facts");
        if (data.StartTime is { } start)
        {
            page.Fact("date", start.ToString("yyyy-MM-dd, dddd", CultureInfo.InvariantCulture));
            page.Fact("begin", TimeOfDay(start));
        }
        else
        {
            page.Fact("date", data.Seed is null ? "not known" : "simulated: no date and no time of day");
        }

        page.Fact("aircraft", Aircraft(data.Record.Telemetry));
        page.Fact("operator", data.OperatorName.Length > 0 ? data.OperatorName : "not named");
        if (data.MissionFile.Length > 0)
            WriteMissionFile();
        page.Close();
    }

    private static string TimeOfDay(DateTimeOffset start)
    {
        string local = start.ToString("HH:mm:ss zzz", CultureInfo.InvariantCulture);
        return start.Offset == TimeSpan.Zero
            ? start.ToString("HH:mm:ss", CultureInfo.InvariantCulture) + " UTC"
            : $"{local} ({start.UtcDateTime.ToString("HH:mm:ss", CultureInfo.InvariantCulture)} UTC)";
    }

    private static string Aircraft(TelemetryRecord telemetry) => telemetry.Autopilot is not { } autopilot
        ? "none was received"
        : $"{telemetry.VehicleType}, {FlightText.Autopilot(autopilot)}, "
            + (telemetry.Firmware is { } firmware ? $"firmware {firmware}, " : "firmware not reported, ")
            + $"system {FlightText.Number(telemetry.SystemId)}";

    // The whole hash to copy, its beginning to compare.
    private void WriteMissionFile()
    {
        page.Element("dt", "mission file").Open("dd").Text(data.MissionFile);
        if (data.MissionFileSha256.Length > HashDigitsShown)
        {
            string beginning = data.MissionFileSha256.Substring(0, HashDigitsShown);
            page.Element("small", $" SHA-256 {beginning}…", "title", data.MissionFileSha256);
            page.CopyButton(data.MissionFileSha256, "copy the SHA-256 of the mission file");
        }

        page.Close();
    }
}
