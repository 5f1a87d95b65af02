using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Reads and writes camera.json.</summary>
internal static class CameraDescription
{
    private const string Format = "uav-imagery-camera";
    private const double TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000.0;

    /// <exception cref="PictureException">It is no JSON, or describes no camera; the text names all that is wrong.</exception>
    public static CameraFolder Parse(byte[] json, string file, string folder)
    {
        JsonDocument document;
        try
        {
            document = JsonDocument.Parse(WithoutMark(json));
        }
        catch (JsonException e)
        {
            throw new PictureException(file, "it is no JSON: " + e.Message, e);
        }

        using (document)
        {
            var fields = new JsonFields();
            JsonElement root = document.RootElement;
            JsonElement camera = fields.Object(root, "camera", string.Empty);
            CameraModel model = ReadModel(camera, fields);
            JsonElement mount = fields.Object(camera, "mount", "camera.");
            double[] matrix = fields.Matrix(mount, "R_body_from_cam", "camera.mount.");
            double[] arm = fields.Numbers(mount, "lever_arm_body_m", "camera.mount.", 3);
            IReadOnlyList<ListedPicture> listed = ReadFrames(root, fields.Faults);

            // Where a number is missing, what it would have meant is not worth a second complaint.
            List<string> faults = fields.Faults;
            CameraMount where = new();
            if (faults.Count == 0)
                where = Check(model, matrix, arm, faults);
            if (faults.Count > 0)
                throw new PictureException(file, string.Join("; ", faults));
            return new CameraFolder(folder, model, where, listed);
        }
    }

    public static byte[] Write(CameraModel camera, CameraExtrinsics placement)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true }))
        {
            json.WriteStartObject();
            json.WriteString("format", Format);
            json.WriteNumber("version", 1);
            json.WriteStartObject("camera");
            json.WriteNumber("width", camera.Width);
            json.WriteNumber("height", camera.Height);
            json.WriteNumber("fx", camera.FocalX);
            json.WriteNumber("fy", camera.FocalY);
            json.WriteNumber("cx", camera.CentreX);
            json.WriteNumber("cy", camera.CentreY);
            WriteNumbers(json, "dist_k1_k2_p1_p2_k3", [camera.K1, camera.K2, camera.P1, camera.P2, camera.K3]);
            if (camera.RowReadout > TimeSpan.Zero)
                json.WriteNumber("row_readout_us", camera.RowReadout.TotalMilliseconds * 1000);
            json.WriteStartObject("mount");
            json.WriteStartArray("R_body_from_cam");
            (double x1, double x2, double x3) = placement.BodyFromCamera.Apply(1, 0, 0);
            (double y1, double y2, double y3) = placement.BodyFromCamera.Apply(0, 1, 0);
            (double z1, double z2, double z3) = placement.BodyFromCamera.Apply(0, 0, 1);
            WriteNumbers(json, name: null, [x1, y1, z1]);
            WriteNumbers(json, name: null, [x2, y2, z2]);
            WriteNumbers(json, name: null, [x3, y3, z3]);
            json.WriteEndArray();
            WriteNumbers(json, "lever_arm_body_m", [placement.PositionMetres.Forward, placement.PositionMetres.Right, placement.PositionMetres.Down]);
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteString("time_source", "names of the pictures: number, start of the exposure in us since 1970 UTC, exposure in us");
            json.WriteEndObject();
        }

        return stream.ToArray();
    }

    private static CameraModel ReadModel(JsonElement camera, JsonFields fields)
    {
        double[] distortion = fields.Numbers(camera, "dist_k1_k2_p1_p2_k3", "camera.", 5);
        return new CameraModel
        {
            Width = fields.WholeNumber(camera, "width", "camera."),
            Height = fields.WholeNumber(camera, "height", "camera."),
            FocalX = fields.Number(camera, "fx", "camera."),
            FocalY = fields.Number(camera, "fy", "camera."),
            CentreX = fields.Number(camera, "cx", "camera."),
            CentreY = fields.Number(camera, "cy", "camera."),
            K1 = distortion[0],
            K2 = distortion[1],
            P1 = distortion[2],
            P2 = distortion[3],
            K3 = distortion[4],
            RowReadout = TimeSpan.FromTicks((long)Math.Round(fields.OptionalNumber(camera, "row_readout_us", "camera.") * TicksPerMicrosecond)),
        };
    }

    private static CameraMount Check(CameraModel model, double[] matrix, double[] arm, List<string> faults)
    {
        faults.AddRange(model.FindFaults());
        if (RgbPicture.FindSizeFault(model.Width, model.Height) is { } fault)
            faults.Add(fault);
        if (!TryRotation(matrix, out Rotation rotation, out string reason))
            faults.Add("R_body_from_cam: " + reason);
        var mount = new CameraMount { FixedBodyFromCamera = rotation, GimbalLeverArmMetres = new BodyVector(arm[0], arm[1], arm[2]) };
        faults.AddRange(mount.FindFaults());
        return mount;
    }

    private static bool TryRotation(double[] matrix, out Rotation rotation, out string reason)
    {
        (rotation, reason) = (Rotation.Identity, string.Empty);
        try
        {
            rotation = Rotation.FromMatrix(matrix);
            return true;
        }
        catch (ArgumentException e)
        {
            // What is wrong, without the name of the parameter that a runtime puts on another line.
            reason = e.Message.Split('\r', '\n')[0];
            int at = reason.IndexOf(" (Parameter", StringComparison.Ordinal);
            reason = at < 0 ? reason : reason.Substring(0, at);
            return false;
        }
    }

    private static void WriteNumbers(Utf8JsonWriter json, string? name, IEnumerable<double> numbers)
    {
        if (name is not null)
            json.WriteStartArray(name);
        else
            json.WriteStartArray();
        foreach (double number in numbers)
            json.WriteNumberValue(number);
        json.WriteEndArray();
    }

    private static List<ListedPicture> ReadFrames(JsonElement root, List<string> faults)
    {
        var listed = new List<ListedPicture>();
        if (root.ValueKind != JsonValueKind.Object || !root.TryGetProperty("frames", out JsonElement frames))
            return listed;
        if (frames.ValueKind != JsonValueKind.Array)
        {
            faults.Add("frames is no list");
            return listed;
        }

        foreach (JsonElement frame in frames.EnumerateArray())
        {
            if (TryReadFrame(frame, listed.Count, out ListedPicture? picture))
            {
                listed.Add(picture!);
                continue;
            }

            faults.Add($"frames, entry {listed.Count + 1}, has no file within the folder, no frame_start_us or no exposure_us");
            break;
        }

        return listed.OrderBy(p => p.Facts.StartUtcMicroseconds).ToList();
    }

    private static bool TryReadFrame(JsonElement frame, int number, out ListedPicture? picture)
    {
        picture = null;
        if (frame.ValueKind != JsonValueKind.Object
            || !frame.TryGetProperty("file", out JsonElement file) || file.ValueKind != JsonValueKind.String
            || !JsonFields.TryLong(frame, "frame_start_us", out long start) || !JsonFields.TryLong(frame, "exposure_us", out long exposure)
            || !PictureFileName.IsPossible(start, exposure))
        {
            return false;
        }

        string name = file.GetString()!;
        string[] steps = name.Split('/', '\\');
        if (name.IndexOfAny(Path.GetInvalidPathChars()) >= 0 || name.Contains(':') || steps.Any(s => s.Length == 0 || s == ".."))
            return false;
        picture = new ListedPicture(name, new PictureFileName(number, start, exposure));
        return true;
    }

    // Some editors begin a file with the mark of UTF-8, which JSON does not know.
    private static ReadOnlyMemory<byte> WithoutMark(byte[] json)
        => json.Length >= 3 && json[0] == 0xEF && json[1] == 0xBB && json[2] == 0xBF ? json.AsMemory(3) : json;
}
