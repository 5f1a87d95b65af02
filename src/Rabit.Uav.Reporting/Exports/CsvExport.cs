using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>CSV, RFC 4180: one table, whose rows are places of several kinds.</summary>
internal sealed class CsvExport
{
    private static readonly string[] Columns =
    [
        "kind", "number", "ring", "latitude_deg", "longitude_deg", "altitude_amsl_m", "time_s", "height_above_home_m",
        "ground_speed_m_per_s", "yaw_deg", "battery_percent", "coverage_percent", "phase", "class", "state",
        "ellipse95_half_major_m", "ellipse95_half_minor_m", "ellipse_major_axis_deg", "reports",
        "bearing_deg", "bearing_deviation_deg", "bearing_symmetry",
    ];

    private readonly TextWriter _output;
    private readonly ExportedFlight _flight;
    private readonly string[] _row = new string[Columns.Length];

    private CsvExport(TextWriter output, ExportedFlight flight) => (_output, _flight) = (output, flight);

    public static void Write(Stream output, FlightSummary summary)
    {
        const int BufferSize = 4096;
        var utf8 = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
        using var text = new StreamWriter(output, utf8, BufferSize, leaveOpen: true);
        new CsvExport(text, new ExportedFlight(summary)).Write();
    }

    private void Write()
    {
        _output.Write(string.Join(",", Columns) + "\r\n");
        WritePlan();
        foreach (FlightSample sample in _flight.Path)
            WriteSample(sample);
        foreach (TargetTrack target in _flight.Targets)
            WriteTarget(target);
        foreach (TargetScore truth in _flight.Truth)
        {
            Begin("truth", truth.Position);
            Set("class", TargetClassNames.Name(truth.Class));
            Set("state", FlightText.ResultOf(truth));
            End();
        }

        WriteSeenGround();
    }

    private void WritePlan()
    {
        if (_flight.Plan is not { } plan)
            return;
        Begin("home", plan.Home);
        Set("altitude_amsl_m", plan.Home.AltitudeAmslMetres, "0.00");
        End();
        int keepOut = 0;
        foreach ((string kind, IReadOnlyList<GeodeticPosition> corners) in _flight.Polygons())
            WriteRing(kind, kind == "keep-out" ? ++keepOut : 1, 0, ExportedFlight.Ring(corners));
        int number = 0;
        foreach ((GeodeticPosition start, GeodeticPosition end) in _flight.Lanes())
        {
            number++;
            foreach (GeodeticPosition place in new[] { start, end })
            {
                Begin("lane", place, number);
                Set("altitude_amsl_m", place.AltitudeAmslMetres, "0.00");
                End();
            }
        }
    }

    private void WriteSample(in FlightSample sample)
    {
        Begin("path", sample.Position);
        Set("altitude_amsl_m", sample.Position.AltitudeAmslMetres, "0.00");
        Set("time_s", sample.Time.TotalSeconds, "0.000");
        Set("height_above_home_m", sample.HeightAboveHomeMetres, "0.00");
        Set("ground_speed_m_per_s", sample.GroundSpeed, "0.00");
        Set("yaw_deg", sample.Yaw.Degrees, "0.0");
        Set("battery_percent", sample.BatteryRemaining * 100, "0.0");
        Set("coverage_percent", sample.Coverage * 100, "0.00");
        Set("phase", FlightText.Phase(sample.Phase));
        End();
    }

    private void WriteTarget(TargetTrack target)
    {
        Begin("target", target.Position, target.Id);
        Set("time_s", target.LastSeen.TotalSeconds, "0.000");
        Set("class", TargetClassNames.Name(target.Class));
        Set("state", ExportedFlight.StateOf(target));
        Set("ellipse95_half_major_m", target.Covariance.HalfMajorAxis95Metres, "0.000");
        Set("ellipse95_half_minor_m", target.Covariance.HalfMinorAxis95Metres, "0.000");
        Set("ellipse_major_axis_deg", target.Covariance.MajorAxis.Degrees, "0.00");
        Set("reports", target.Reports, "0");
        if (target.Bearing is { } bearing)
        {
            Set("bearing_deg", bearing.Angle.Degrees, "0.00");
            Set("bearing_deviation_deg", bearing.TotalSigma.Degrees, "0.00");
            Set("bearing_symmetry", bearing.Symmetry.ToString());
        }

        End();
    }

    private void WriteSeenGround()
    {
        int number = 0;
        foreach (SeenPatch patch in _flight.SeenGround())
        {
            WriteRing("coverage", ++number, 0, ExportedFlight.Ring(patch.Outline));
            for (int hole = 0; hole < patch.Holes.Count; hole++)
                WriteRing("coverage", number, hole + 1, ExportedFlight.Ring(patch.Holes[hole], isHole: true));
        }
    }

    // Ring 0 is the outline, the others are holes.
    private void WriteRing(string kind, int number, int index, IReadOnlyList<GeodeticPosition> ring)
    {
        foreach (GeodeticPosition corner in ring)
        {
            Begin(kind, corner, number);
            Set("ring", index, "0");
            End();
        }
    }

    private void Begin(string kind, GeodeticPosition position, int? number = null)
    {
        for (int index = 0; index < _row.Length; index++)
            _row[index] = string.Empty;
        Set("kind", kind);
        if (number is { } known)
            Set("number", known, "0");
        Set("latitude_deg", position.Latitude.Degrees, "0.0000000");
        Set("longitude_deg", position.Longitude.Degrees, "0.0000000");
    }

    private void End() => _output.Write(string.Join(",", _row.Select(Quoted)) + "\r\n");

    private void Set(string column, string value)
        => _row[Array.IndexOf(Columns, column)] = ExportedFlight.Printable(value);

    private void Set(string column, double value, string format)
    {
        if (!double.IsNaN(value) && !double.IsInfinity(value))
            Set(column, value.ToString(format, CultureInfo.InvariantCulture));
    }

    private static string Quoted(string field)
        => field.IndexOfAny([',', '"']) < 0 ? field : "\"" + field.Replace("\"", "\"\"") + "\"";
}
