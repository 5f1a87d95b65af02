using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Files;

namespace Rabit.Vision;

/// <summary>
/// Templates as text: lines of "key value", then the weights, a line for each cell, then a CRC-32 of all before it
/// (docs/template-file.md). Nothing is taken from a file that is not whole.
/// </summary>
internal static class TemplateFile
{
    private const string FirstLine = "rabit-template 1";
    private const string ChecksumKey = "crc32 ";
    private const int MaxBytes = 4 << 20;

    /// <exception cref="PictureException">It cannot be read, or is no template.</exception>
    public static ObjectTemplate Load(string path)
    {
        byte[] bytes;
        if (SpecialFile.FindKind(path) is { } kind)
            throw new PictureException(path, $"it is {kind}, not a file");
        try
        {
            using FileStream file = File.OpenRead(path);
            if (file.Length > MaxBytes)
                throw new PictureException(path, $"it has {file.Length} bytes; a template has at most {MaxBytes}");
            bytes = new byte[(int)file.Length];
            int at = 0;
            while (at < bytes.Length)
            {
                int count = file.Read(bytes, at, bytes.Length - at);
                if (count == 0)
                    throw new PictureException(path, "it became shorter while it was read");
                at += count;
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException
            or NotSupportedException)
        {
            throw new PictureException(path, "it cannot be read: " + e.Message, e);
        }

        return Parse(bytes, path);
    }

    /// <param name="bytes">The file.</param>
    /// <param name="name">What it is called in errors.</param>
    /// <exception cref="PictureException">It is no template.</exception>
    public static ObjectTemplate Parse(byte[] bytes, string name)
    {
        try
        {
            return Parse(new TemplateLines(CheckedText(bytes)));
        }
        catch (FormatException e)
        {
            throw new PictureException(name, "it is no template of Rabit: " + e.Message, e);
        }
    }

    public static byte[] Format(ObjectTemplate template)
    {
        var text = new StringBuilder(FirstLine + "\n");
        void Line(string key, FormattableString value)
            => text.Append(key).Append(' ').Append(value.ToString(CultureInfo.InvariantCulture)).Append('\n');
        Line("name", $"{template.Name}");
        Line("lengthMetres", $"{template.LengthMetres:R}");
        Line("widthMetres", $"{template.WidthMetres:R}");
        Line("metresPerPixel", $"{template.MetresPerPixel:R}");
        Line("cellPixels", $"{template.CellPixels}");
        Line("cellsLong", $"{template.CellsLong}");
        Line("cellsWide", $"{template.CellsWide}");
        Line("headings", $"{template.Headings}");
        Line("threshold", $"{template.Threshold:R}");
        Line("sigmaMetres", $"{template.SigmaMetres:R}");
        Line("bias", $"{template.Bias:R}");
        Line("slope", $"{template.Slope:R}");
        Line("offset", $"{template.Offset:R}");
        Line("weights", $"{template.Weights.Length}");
        for (int at = 0; at < template.Weights.Length; at += HogFeatures.Dimensions)
        {
            IEnumerable<string> cell = template.Weights.Skip(at).Take(HogFeatures.Dimensions)
                .Select(w => w.ToString("R", CultureInfo.InvariantCulture));
            text.Append(string.Join(" ", cell)).Append('\n');
        }

        byte[] body = Encoding.ASCII.GetBytes(text.ToString());
        return [.. body, .. Encoding.ASCII.GetBytes(ChecksumKey + Checksum(body) + "\n")];
    }

    // The lines before the checksum, once that fits. A file that went through Windows may have other line ends.
    private static string[] CheckedText(byte[] bytes)
    {
        if (bytes.Any(b => b > 126))
            throw new FormatException("it is not plain text");
        string text = Encoding.ASCII.GetString(bytes).Replace("\r\n", "\n");
        if (!text.StartsWith(FirstLine + "\n", StringComparison.Ordinal))
            throw new FormatException($"it does not begin with \"{FirstLine}\"");
        int last = text.LastIndexOf("\n" + ChecksumKey, StringComparison.Ordinal) + 1;
        if (last == 0)
            throw new FormatException($"there is no line \"{ChecksumKey.TrimEnd()}\" at its end; it is cut");
        byte[] body = Encoding.ASCII.GetBytes(text.Substring(0, last));
        string crc = Checksum(body);
        if (text.Substring(last + ChecksumKey.Length).TrimEnd('\n') != crc)
            throw new FormatException($"its checksum is not {crc}; it was damaged or changed");
        return text.Substring(0, last - 1).Split('\n');
    }

    private static string Checksum(byte[] body)
        => Checksums.Crc32(body, 0, body.Length).ToString("x8", CultureInfo.InvariantCulture);

    private static ObjectTemplate Parse(TemplateLines lines)
    {
        var template = new ObjectTemplate
        {
            Name = lines.Text("name"),
            LengthMetres = lines.Number("lengthMetres"),
            WidthMetres = lines.Number("widthMetres"),
            MetresPerPixel = lines.Number("metresPerPixel"),
            CellPixels = lines.Whole("cellPixels"),
            CellsLong = lines.Whole("cellsLong"),
            CellsWide = lines.Whole("cellsWide"),
            Headings = lines.Whole("headings"),
            Threshold = lines.Number("threshold"),
            SigmaMetres = lines.Number("sigmaMetres"),
            Bias = lines.Number("bias"),
            Slope = lines.Number("slope"),
            Offset = lines.Number("offset"),
        };
        string[] faults = template.FindFaults().ToArray();
        if (faults.Length > 0)
            throw new FormatException(string.Join("; ", faults));
        // Only now is the number of weights one that can be allocated.
        int cells = template.CellsLong * template.CellsWide;
        int count = lines.Whole("weights");
        if (count != cells * HogFeatures.Dimensions)
            throw new FormatException($"it has {count} weights; its window needs {cells * HogFeatures.Dimensions}");
        template.Weights = lines.Weights(cells);
        return template;
    }
}
