using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Files;
using Rabit.Vision;

namespace Rabit.Tool.Training;

/// <summary>
/// Labelled pictures: a list of files, relative to the labels, with the side of a pixel on the ground and the boxes
/// around the objects. The first fault is named with file and path of the field.
/// </summary>
internal sealed class LabelFile
{
    private const double MinMetresPerPixel = 0.0001;

    private LabelFile(IReadOnlyList<LabelledPicture> pictures) => Pictures = pictures;

    public IReadOnlyList<LabelledPicture> Pictures { get; }

    /// <exception cref="FormatException">It cannot be read, or is none.</exception>
    public static LabelFile Load(string path)
    {
        if (SpecialFile.FindKind(path) is { } kind)
            throw new FormatException($"{path}: it is {kind}, not a file");
        if (Directory.Exists(path))
            throw new FormatException($"{path}: that is a folder");
        string text;
        try
        {
            text = File.ReadAllText(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException
            or NotSupportedException)
        {
            throw new FormatException($"{path}: it cannot be read: {e.Message}", e);
        }

        try
        {
            using JsonDocument document = JsonDocument.Parse(text);
            var root = new LabelFields(document.RootElement, path, "", "pictures");
            string folder = Path.GetDirectoryName(Path.GetFullPath(path))!;
            var pictures = root.List("pictures")
                .Select((p, i) => Picture(p, path, $"pictures[{i}]", folder)).ToList();
            if (pictures.Count == 0)
                throw new FormatException($"{path}: pictures is empty");
            return new LabelFile(pictures);
        }
        catch (JsonException e)
        {
            throw new FormatException($"{path}: it is not JSON: {e.Message}", e);
        }
    }

    private static LabelledPicture Picture(JsonElement json, string file, string where, string folder)
    {
        var fields = new LabelFields(json, file, where, "file", "metresPerPixel", "group", "boxes");
        return new LabelledPicture
        {
            Path = Path.Combine(folder, fields.Text("file")),
            Field = where,
            MetresPerPixel = fields.NumberFrom("metresPerPixel", MinMetresPerPixel),
            Group = fields.Has("group") ? fields.Text("group") : null,
            Boxes = fields.List("boxes").Select((b, i) => Box(b, file, $"{where}.boxes[{i}]")).ToList(),
        };
    }

    private static TrainingBox Box(JsonElement json, string file, string where)
    {
        var fields = new LabelFields(
            json, file, where, "left", "top", "width", "height", "headingDegrees", "ignored");
        return new TrainingBox(
            fields.Number("left"), fields.Number("top"), fields.Number("width"), fields.Number("height"))
        {
            HeadingRadians = fields.Has("headingDegrees")
                ? fields.NumberWithin("headingDegrees", 360) * Math.PI / 180
                : null,
            IsIgnored = fields.Has("ignored") && fields.Flag("ignored"),
        };
    }
}
