using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Communications;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A recorded log that a test makes, in a folder of its own that goes with it.</summary>
internal sealed class TestLog : IDisposable
{
    /// <summary>Some day in 2026, microseconds since 1970.</summary>
    public const long Start = 1_790_000_000_000_000;

    private readonly List<RecordedFile> _open = [];

    public TestLog(string name = "test.tlog")
    {
        Folder = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "rabit-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(Folder);
        Path = System.IO.Path.Combine(Folder, name);
        File.WriteAllBytes(Path, []);
    }

    public string Folder { get; }

    public string Path { get; }

    public string Url => "tlog:" + Path;

    /// <summary>Adds a record; the stamp counts from <see cref="Start"/>.</summary>
    public TestLog Record(long microseconds, byte[] frame)
    {
        var stamp = new byte[8];
        for (int i = 0; i < stamp.Length; i++)
            stamp[i] = (byte)((Start + microseconds) >> (56 - (8 * i)));
        return Raw(stamp).Raw(frame);
    }

    public TestLog Raw(byte[] bytes)
    {
        using var stream = new FileStream(Path, FileMode.Append);
        stream.Write(bytes, 0, bytes.Length);
        return this;
    }

    /// <summary>Opens it to be played at the pace of the clock it runs by.</summary>
    public RecordedFile Open(MavlinkDialect? dialect = null, string option = "?speed=max")
    {
        RecordedFile file = RecordedFile.Open(LinkUrl.Parse(Url + option), dialect);
        _open.Add(file);
        return file;
    }

    public void Dispose()
    {
        _open.ForEach(f => f.Dispose());
        Directory.Delete(Folder, recursive: true);
    }
}
