using System;
using System.IO;
using System.Text;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Geolocate;

/// <summary>Tells a place, or why there is none.</summary>
internal static class Answer
{
    private const double Degree = Math.PI / 180;

    /// <returns>The exit code: 0 for a place, 2 for a refusal.</returns>
    public static int Write(GeolocationResult fix, bool isJson, TextWriter output)
    {
        output.WriteLine(isJson ? Json(fix) : Text(fix));
        return fix.Refusal == GeolocationError.None ? 0 : 2;
    }

    private static string Text(GeolocationResult fix)
    {
        if (fix.Refusal != GeolocationError.None)
            return $"refused: {fix.Refusal}: {Reason(fix.Refusal)}";
        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        GeographicPoint point = fix.Position.Point;
        double latitude = point.Latitude.Degrees;
        string grid = latitude is >= -80 and <= 84 ? "  " + PositionText.Format(point, PositionStyle.Mgrs) : "";
        return FormattableString.Invariant(
            $"{PositionText.Format(point, PositionStyle.DecimalDegrees)}  {PositionText.Format(point, PositionStyle.DegreesMinutesSeconds)}{grid}\naltitude {fix.Position.AltitudeAmslMetres:0.00} m\n95 % ellipse {all.HalfMajorAxis95Metres:0.0} x {all.HalfMinorAxis95Metres:0.0} m, long axis at {all.MajorAxisRadians / Degree:0} deg from north\nof which anew in each look {fix.Covariance.HalfMajorAxis95Metres:0.0} m, the same in all {fix.SystematicCovariance.HalfMajorAxis95Metres:0.0} m\n") + Drawn(fix);
    }

    private static string Reason(GeolocationError refusal) => refusal switch
    {
        GeolocationError.OutsidePicture => "the pixel is not in the picture",
        GeolocationError.LensCannotBeUndone => "the formula of the lens cannot be undone there",
        GeolocationError.NearHorizon => "the line of sight points above the horizon, or too little below it",
        GeolocationError.CameraBelowGround => "the camera is below the ground",
        GeolocationError.LeavesTerrain => "the line of sight leaves the grid of heights above the ground",
        GeolocationError.NoTerrainData => "the line of sight may meet the ground where the grid has no height",
        GeolocationError.NoPose => "no pose reaches the time of the picture",
        GeolocationError.PoseTooOld => "the picture is older than all poses",
        GeolocationError.PoseGap => "the poses around the time of the picture are too far apart",
        _ => "there is no place",
    };

    private static string Drawn(GeolocationResult fix) => fix.Extrapolated > TimeSpan.Zero
        ? FormattableString.Invariant($"pose drawn on by {fix.Extrapolated.TotalMilliseconds:0} ms") : "pose between samples";

    private static string Json(GeolocationResult fix)
    {
        using var stream = new MemoryStream();
        using (var writer = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true }))
        {
            writer.WriteStartObject();
            writer.WriteString("status", fix.Refusal == GeolocationError.None ? "ok" : "refused");
            writer.WriteNumber("time_s", fix.Time.TotalSeconds);
            if (fix.Refusal == GeolocationError.None)
                WritePlace(writer, fix);
            else
            {
                writer.WriteString("reason", fix.Refusal.ToString());
                writer.WriteString("text", Reason(fix.Refusal));
            }

            writer.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static void WritePlace(Utf8JsonWriter writer, GeolocationResult fix)
    {
        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        writer.WriteNumber("lat_deg", fix.Position.LatitudeRadians / Degree);
        writer.WriteNumber("lon_deg", fix.Position.LongitudeRadians / Degree);
        writer.WriteNumber("alt_m", fix.Position.AltitudeAmslMetres);
        WriteCovariance(writer, "cov_per_look_ne_m2", fix.Covariance);
        WriteCovariance(writer, "cov_common_ne_m2", fix.SystematicCovariance);
        writer.WriteNumber("half_major_95_m", all.HalfMajorAxis95Metres);
        writer.WriteNumber("half_minor_95_m", all.HalfMinorAxis95Metres);
        writer.WriteNumber("major_axis_deg", all.MajorAxisRadians / Degree);
        writer.WriteNumber("extrapolated_s", fix.Extrapolated.TotalSeconds);
    }

    private static void WriteCovariance(Utf8JsonWriter writer, string name, HorizontalCovariance covariance)
    {
        writer.WriteStartArray(name);
        writer.WriteNumberValue(covariance.NorthNorth);
        writer.WriteNumberValue(covariance.NorthEast);
        writer.WriteNumberValue(covariance.EastEast);
        writer.WriteEndArray();
    }
}
