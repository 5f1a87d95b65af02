using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.Tests;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>A telemetry record in the words of <see cref="SidecarFacts"/>.</summary>
internal static class TelemetryFacts
{
    private static readonly string[] RangeNames = ["lat", "lon", "alt", "relative_alt"];

    public static void AssertAgrees(JsonElement facts, TelemetryRecord telemetry)
    {
        Assert.Equal(facts.GetProperty("first_us").GetInt64(), telemetry.FirstUtcMicroseconds);
        Assert.Equal(facts.GetProperty("last_us").GetInt64(), telemetry.LastUtcMicroseconds);
        Assert.Equal(SidecarFacts.ModeChanges(facts), telemetry.ModeChanges.Select(Text));
        Assert.Equal(SidecarFacts.Acknowledgements(facts), telemetry.Acknowledgements.Select(Text));
        Assert.Equal(SidecarFacts.Texts(facts), telemetry.StatusTexts.Select(Text));
        Assert.Equal(SidecarFacts.Ranges(facts), Ranges(telemetry));
    }

    public static IEnumerable<string> Describe(TelemetryRecord telemetry) =>
    [
        SidecarFacts.Line(
            telemetry.Autopilot!, telemetry.VehicleType!, telemetry.SystemId, telemetry.ComponentId, telemetry.Frames),
        SidecarFacts.Line(telemetry.FirstUtcMicroseconds!, telemetry.LastUtcMicroseconds!),
        .. telemetry.ModeChanges.Select(c => c.Mode + " " + Text(c)),
        .. telemetry.Acknowledgements.Select(Text),
        .. telemetry.StatusTexts.Select(Text),
        .. Ranges(telemetry),
    ];

    private static IEnumerable<string> Ranges(TelemetryRecord telemetry)
        => RangeNames.Zip(
            new[]
            {
                telemetry.LatitudeDegE7, telemetry.LongitudeDegE7, telemetry.AltitudeAmslMillimetres,
                telemetry.HeightAboveHomeMillimetres
            },
            (name, range) => SidecarFacts.Line(name, range!.Value.Minimum, range.Value.Maximum));

    private static string Text(FlightModeChange c)
        => SidecarFacts.Line(
            c.Record, c.UtcMicroseconds, c.CustomMode, (long)c.BaseMode, c.IsArmed, (long)c.SystemStatus);

    private static string Text(FlightAcknowledgement a) => SidecarFacts.Line(
        a.Record, a.UtcMicroseconds, (long)a.Command, (long)a.Result, a.Progress, a.ResultParam2, a.TargetSystem,
        a.TargetComponent);

    private static string Text(FlightStatusText t)
        => SidecarFacts.Line(t.Record, t.UtcMicroseconds, t.SystemId, t.ComponentId, (long)t.Severity, t.Text);
}
