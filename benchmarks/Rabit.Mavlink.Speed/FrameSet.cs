using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;

namespace Rabit.Mavlink.Speed;

/// <summary>
/// The frames of a file one after another, as a link would carry them, and what is needed to make them again.
/// </summary>
internal sealed class FrameSet
{
    private FrameSet(string name, byte[] stream)
    {
        Name = name;
        Stream = stream;
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var frames = new List<MavlinkFrame>();
        var infos = new List<MavlinkFrameInfo>();
        ReadOnlySpan<byte> rest = stream;
        while (reader.TryRead(ref rest, out MavlinkFrame frame, out MavlinkFrameInfo info))
        {
            frames.Add(frame);
            infos.Add(info);
        }

        while (reader.TryFlush(out MavlinkFrame frame, out MavlinkFrameInfo info))
        {
            frames.Add(frame);
            infos.Add(info);
        }

        Frames = [.. frames];
        Infos = [.. infos];
        Messages = Frames.Select(frame => SampleMessage.Of(frame)).ToArray();
    }

    public string Name { get; }

    public byte[] Stream { get; }

    public MavlinkFrame[] Frames { get; }

    public MavlinkFrameInfo[] Infos { get; }

    /// <summary>The message of each frame.</summary>
    public SampleMessage[] Messages { get; }

    /// <summary>Reads a .tlog, or the typical MAVLink 2 frames of golden.jsonl.</summary>
    public static FrameSet Load(string path)
    {
        using var stream = new MemoryStream();
        if (path.EndsWith(".jsonl", StringComparison.Ordinal))
            CopyGolden(path, stream);
        else
            CopyLog(path, stream);
        return new FrameSet(Path.GetFileName(path), stream.ToArray());
    }

    private static void CopyLog(string path, MemoryStream to)
    {
        var wire = new byte[MavlinkFrame.MaxWireLength];
        using FileStream file = File.OpenRead(path);
        var log = new TlogReader(file, MavlinkDialect.All);
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            if (record.IsChecked)
                to.Write(wire, 0, frame.WriteTo(wire));
        }
    }

    private static void CopyGolden(string path, MemoryStream to)
    {
        foreach (string line in File.ReadLines(path))
        {
            using var vector = JsonDocument.Parse(line);
            if (vector.RootElement.GetProperty("case").GetString() != "typical")
                continue;
            string hex = vector.RootElement.GetProperty("v2").GetString()!;
            for (int index = 0; index < hex.Length; index += 2)
                to.WriteByte(Convert.ToByte(hex.Substring(index, 2), 16));
        }
    }
}
