using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Json;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Reads and writes camera.json.</summary>
internal static class CameraDescription
{
    private const string Format = "uav-imagery-camera";
    private const int Version = 2;

    // For people and other programs; they change nothing here.
    private static readonly string[] Notes = ["format", "version", "timeSource", "origin"];

    /// <summary>Key of what the camera's clock is ahead of UTC.</summary>
    public const string ExifUtcOffset = "exifUtcOffset";

    private const string FrameStart = "frameStartMicroseconds";
    private const string Exposure = "exposureMicroseconds";
    private const string TimeNoise = "timeNoiseMicroseconds";
    private const double MaxTimeNoise = 10e6;

    /// <exception cref="PictureException">
    /// It is no JSON, or describes no camera; the text names all that is wrong.
    /// </exception>
    public static CameraFolder Parse(byte[] json, string file, string folder)
    {
        using (JsonDocument document = Parse(json, file))
        {
            var faults = new List<string>();
            var root = new JsonFields(document.RootElement, string.Empty, faults);
            JsonFields camera = root.RequiredObject("camera");
            CameraModel model = CameraModelDescription.Read(camera, faults);
            CameraMount mount = CameraMountDescription.Read(camera.RequiredObject("mount"), faults);
            camera.RefuseOthers();
            CameraSource? source = root.Has("source")
                ? CameraSourceDescription.Read(root.RequiredObject("source"), model, folder, faults)
                : null;
            List<ListedPicture> listed = ReadFrames(root, faults);
            TimeSpan? timeNoise = ReadTimeNoise(root, source is not null, faults);
            TimeSpan? exifUtcOffset = ReadUtcOffset(root, source is not null, faults);
            if (source is not null && root.Has("frames"))
                faults.Add("there are both a source, which gives the pictures, and frames, which lists them");
            root.Renamed(("time_source", "timeSource"), ("mount", "camera.mount"));
            foreach (string note in Notes)
                root.Has(note);
            root.RefuseOthers();

            // Where a number is missing, what it would have meant is not worth a second fault.
            if (faults.Count == 0)
                faults.AddRange(FindFaults(model, mount));
            if (faults.Count > 0)
                throw new PictureException(file, string.Join("; ", faults));
            return new CameraFolder(folder, model, mount, listed)
            {
                Source = source,
                TimeNoise = timeNoise ?? CameraFolder.DefaultTimeNoise,
                ExifUtcOffset = exifUtcOffset,
            };
        }
    }

    private static JsonDocument Parse(byte[] json, string file)
    {
        JsonDocument? document = null;
        try
        {
            document = JsonDocument.Parse(WithoutMark(json));
            JsonTexts.Demand(document.RootElement);
            return document;
        }
        catch (JsonException e)
        {
            document?.Dispose();
            throw new PictureException(file, "it is not JSON: " + e.Message, e);
        }
    }

    public static byte[] Write(CameraModel camera, CameraExtrinsics placement)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true }))
        {
            json.WriteStartObject();
            json.WriteString("format", Format);
            json.WriteNumber("version", Version);
            json.WriteStartObject("camera");
            CameraModelDescription.Write(json, camera);
            json.WriteStartObject("mount");
            json.WriteStartArray(CameraMountDescription.BodyFromCamera);
            (double x1, double x2, double x3) = placement.BodyFromCamera.Apply(1, 0, 0);
            (double y1, double y2, double y3) = placement.BodyFromCamera.Apply(0, 1, 0);
            (double z1, double z2, double z3) = placement.BodyFromCamera.Apply(0, 0, 1);
            WriteNumbers(json, name: null, [x1, y1, z1]);
            WriteNumbers(json, name: null, [x2, y2, z2]);
            WriteNumbers(json, name: null, [x3, y3, z3]);
            json.WriteEndArray();
            WriteNumbers(
                json, CameraMountDescription.LeverArm,
                [placement.PositionMetres.Forward, placement.PositionMetres.Right, placement.PositionMetres.Down]);
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteString(
                "timeSource",
                "names of the pictures: number, start of the exposure in us since 1970 UTC, exposure in us");
            json.WriteEndObject();
        }

        return stream.ToArray();
    }

    private static IEnumerable<string> FindFaults(CameraModel model, CameraMount mount)
    {
        IEnumerable<string> faults = model.FindFaults();
        if (RgbPicture.FindSizeFault(model.Width, model.Height) is { } fault)
            faults = faults.Append(fault);
        return faults.Concat(mount.FindFaults());
    }

    internal static void WriteNumbers(Utf8JsonWriter json, string? name, IEnumerable<double> numbers)
    {
        if (name is not null)
            json.WriteStartArray(name);
        else
            json.WriteStartArray();
        foreach (double number in numbers)
            json.WriteNumberValue(number);
        json.WriteEndArray();
    }

    // Of pictures in files: a source has its own, which may depend on what it finds.
    private static TimeSpan? ReadTimeNoise(JsonFields root, bool hasSource, List<string> faults)
    {
        if (!root.Has(TimeNoise))
            return null;
        if (hasSource)
            faults.Add($"{TimeNoise} is of pictures in files; that of a source is source.{TimeNoise}");
        if (root.Number(TimeNoise) is not { } number || double.IsNaN(number))
            return null;
        if (!(number >= 0 && number <= MaxTimeNoise))
        {
            faults.Add(FormattableString.Invariant($"{TimeNoise} is {number}; it must be 0 to {MaxTimeNoise}"));
            return null;
        }

        return TimeSpan.FromTicks((long)(number * PictureFolderWriter.TicksPerMicrosecond));
    }

    private static TimeSpan? ReadUtcOffset(JsonFields root, bool hasSource, List<string> faults)
    {
        if (!root.Has(ExifUtcOffset) || root.Text(ExifUtcOffset) is not { } text)
            return null;
        if (hasSource)
            faults.Add($"{ExifUtcOffset} is of pictures in files, not of a source");
        if (PhotoMetadata.TryParseUtcOffset(text, out TimeSpan offset))
            return offset;
        faults.Add($"{ExifUtcOffset} is \"{text}\"; it must be as \"+02:00\", -14:00 to +14:00");
        return null;
    }

    private static List<ListedPicture> ReadFrames(JsonFields root, List<string> faults)
    {
        var listed = new List<ListedPicture>();
        if (root.Array("frames") is not { } frames)
            return listed;
        foreach (JsonElement frame in frames.EnumerateArray())
        {
            string where = FormattableString.Invariant($"frames[{listed.Count}]");
            var fields = new JsonFields(frame, where, faults);
            fields.Renamed(("frame_start_us", FrameStart), ("exposure_us", Exposure));
            bool isPicture = TryReadFrame(fields, listed.Count, out ListedPicture? picture);
            fields.RefuseOthers();
            if (isPicture)
            {
                listed.Add(picture!);
                continue;
            }

            faults.Add($"{where} has no file within the folder, no {FrameStart} or no {Exposure}");
            break;
        }

        return listed.OrderBy(p => p.Facts.StartUtcMicroseconds).ToList();
    }

    private static bool TryReadFrame(JsonFields frame, int number, out ListedPicture? picture)
    {
        picture = null;
        string? name = frame.Text("file");
        long? start = frame.Long(FrameStart);
        long? exposure = frame.Long(Exposure);
        if (name is null || start is null || exposure is null
            || !PictureFileName.IsPossible(start.Value, exposure.Value))
            return false;

        string[] steps = name.Split('/', '\\');
        if (name.IndexOfAny(Path.GetInvalidPathChars()) >= 0 || name.Contains(':')
            || steps.Any(s => s.Length == 0 || s == ".."))
            return false;
        picture = new ListedPicture(name, new PictureFileName(number, start.Value, exposure.Value));
        return true;
    }

    // Some editors begin a file with the mark of UTF-8, which JSON does not know.
    private static ReadOnlyMemory<byte> WithoutMark(byte[] json)
        => json.Length >= 3 && json[0] == 0xEF && json[1] == 0xBB && json[2] == 0xBF ? json.AsMemory(3) : json;
}
