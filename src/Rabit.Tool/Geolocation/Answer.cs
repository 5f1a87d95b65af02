using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Tool.Geolocation;

/// <summary>Writes places, or why there is none.</summary>
internal static class Answer
{
    /// <param name="pixels">One at least.</param>
    /// <param name="isList">Whether it is a list, though it may have one entry.</param>
    /// <param name="isJson">Whether to write JSON.</param>
    /// <param name="output">Where it goes.</param>
    /// <returns>The exit code: where one is refused, that it was not found.</returns>
    public static int Write(IReadOnlyList<LocatedPixel> pixels, bool isList, bool isJson, TextWriter output)
    {
        if (isJson)
            output.WriteLine(Json(pixels, isList));
        else if (!isList)
            output.WriteLine(Text(pixels[0]));
        else
        {
            foreach (LocatedPixel pixel in pixels)
                output.WriteLine(Line(pixel));
        }

        return pixels.All(p => p.IsLocated) ? ToolExitCode.Done : ToolExitCode.NotFound;
    }

    private static string Line(LocatedPixel pixel)
    {
        string name = FormattableString.Invariant($"pixel {pixel.Column},{pixel.Row}: ");
        if (!pixel.IsLocated)
            return name + Text(pixel);
        GeolocationResult fix = pixel.Result;
        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        return name + PositionText.Format(fix.Position.Point, PositionStyle.DecimalDegrees)
            + FormattableString.Invariant(
                $"  altitude {fix.Position.AltitudeAmslMetres:0.00} m  95 % ellipse {all.HalfMajorAxis95Metres:0.0} x {all.HalfMinorAxis95Metres:0.0} m, long axis at {all.MajorAxis.Degrees:0} deg from north");
    }

    private static string Text(LocatedPixel pixel)
    {
        GeolocationResult fix = pixel.Result;
        if (fix.Error != GeolocationError.None)
            return $"refused: {fix.Error}: {Reason(fix.Error)}";
        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        GeographicPoint point = fix.Position.Point;
        double latitude = point.Latitude.Degrees;
        string grid = latitude is >= -80 and <= 84 ? "  " + PositionText.Format(point, PositionStyle.Mgrs) : "";
        string where = $"{PositionText.Format(point, PositionStyle.DecimalDegrees)}  "
            + $"{PositionText.Format(point, PositionStyle.DegreesMinutesSeconds)}{grid}";
        return FormattableString.Invariant($"""
            {where}
            altitude {fix.Position.AltitudeAmslMetres:0.00} m
            95 % ellipse {all.HalfMajorAxis95Metres:0.0} x {all.HalfMinorAxis95Metres:0.0} m, long axis at {all.MajorAxis.Degrees:0} deg from north
            of which random {fix.Covariance.HalfMajorAxis95Metres:0.0} m, systematic {fix.SystematicCovariance.HalfMajorAxis95Metres:0.0} m
            """) + (pixel.IsTimed ? Environment.NewLine + PoseText(fix) : "");
    }

    /// <summary>Why there is no place, for people.</summary>
    public static string Reason(GeolocationError refusal) => refusal switch
    {
        GeolocationError.OutsidePicture => "the pixel is not in the picture",
        GeolocationError.LensCannotBeUndone => "the lens distortion cannot be undone there",
        GeolocationError.NearHorizon => "the ray points above the horizon, or too little below it",
        GeolocationError.NotANumber => "the height of the ground, or an angle of the camera, is not a number",
        GeolocationError.CameraBelowGround => "the camera is below the ground",
        GeolocationError.LeavesTerrain => "the ray leaves the terrain grid above the ground",
        GeolocationError.NoTerrainData => "the ray may intersect the ground where the terrain grid has no altitude",
        GeolocationError.NoPose => "no pose, or no report of a gimbal that reports, reaches the time of the picture",
        GeolocationError.PoseTooOld => "the picture is older than all poses",
        GeolocationError.PoseGap => "the poses, or a gimbal's reports, around the time of the picture are too far apart",
        _ => "there is no place",
    };

    private static string PoseText(GeolocationResult fix) => fix.Extrapolated > TimeSpan.Zero
        ? FormattableString.Invariant($"pose extrapolated by {fix.Extrapolated.TotalMilliseconds:0} ms")
        : "pose between samples";

    private static string Json(IReadOnlyList<LocatedPixel> pixels, bool isList)
    {
        using var stream = new MemoryStream();
        using (var writer = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true }))
        {
            if (isList)
                writer.WriteStartArray();
            foreach (LocatedPixel pixel in pixels)
                WritePixel(writer, pixel);
            if (isList)
                writer.WriteEndArray();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static void WritePixel(Utf8JsonWriter writer, LocatedPixel pixel)
    {
        GeolocationResult fix = pixel.Result;
        writer.WriteStartObject();
        writer.WriteString("status", pixel.IsLocated ? "ok" : "refused");
        writer.WriteStartArray("pixel");
        writer.WriteNumberValue(pixel.Column);
        writer.WriteNumberValue(pixel.Row);
        writer.WriteEndArray();
        if (pixel.IsTimed)
            writer.WriteNumber("timeSeconds", fix.Time.TotalSeconds);
        if (pixel.IsLocated)
        {
            WritePlace(writer, fix);
            if (pixel.IsTimed)
                writer.WriteNumber("extrapolatedSeconds", fix.Extrapolated.TotalSeconds);
        }
        else
        {
            writer.WriteString("reason", fix.Error.ToString());
            writer.WriteString("text", Reason(fix.Error));
        }

        writer.WriteEndObject();
    }

    private static void WritePlace(Utf8JsonWriter writer, GeolocationResult fix)
    {
        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        writer.WriteNumber("latitudeDegrees", fix.Position.Latitude.Degrees);
        writer.WriteNumber("longitudeDegrees", fix.Position.Longitude.Degrees);
        writer.WriteNumber("altitudeAmslMetres", fix.Position.AltitudeAmslMetres);
        WriteCovariance(writer, "randomCovarianceSquareMetres", fix.Covariance);
        WriteCovariance(writer, "systematicCovarianceSquareMetres", fix.SystematicCovariance);
        writer.WriteNumber("ellipse95HalfMajorAxisMetres", all.HalfMajorAxis95Metres);
        writer.WriteNumber("ellipse95HalfMinorAxisMetres", all.HalfMinorAxis95Metres);
        writer.WriteNumber("ellipseMajorAxisDegrees", all.MajorAxis.Degrees);
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
