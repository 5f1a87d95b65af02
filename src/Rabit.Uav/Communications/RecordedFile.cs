using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Links;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// A recorded flight (.tlog) as a link: it gives the frames of its records with their stamps, and takes nothing. The
/// one link that knows MAVLink, because a record is more than its bytes. One thread at a time, but for the figures,
/// which any thread may read.
/// </summary>
public sealed class RecordedFile : IDisposable
{
    private readonly FileStream _stream;
    private readonly TlogReader _reader;

    // Guards the reader: the figures are read from other threads.
    private readonly object _gate = new();
    private readonly MavlinkFrame _firstFrame;
    private readonly TlogRecord _firstRecord;
    private bool _holdsFirst;

    private RecordedFile(LinkUrl url, FileStream stream, MavlinkDialect dialect)
    {
        Url = url;
        _stream = stream;
        Length = stream.Length;
        _reader = new TlogReader(stream, dialect);
        _holdsFirst = TryReadRecord(out _firstFrame, out _firstRecord);
        StartUtcMicroseconds = _firstRecord.TimeMicroseconds;
    }

    /// <summary>What it was opened by.</summary>
    public LinkUrl Url { get; }

    /// <summary>Length of the file, bytes.</summary>
    public long Length { get; }

    /// <summary>Stamp of the first record, microseconds since 1970 UTC.</summary>
    public long StartUtcMicroseconds { get; }

    /// <summary>How much of the file has been read, 0 to 1. Any thread.</summary>
    public double Progress
    {
        get
        {
            lock (_gate)
                // a log may grow while it is read
                return Length == 0 ? 1 : Math.Min(1, (double)_reader.Position / Length);
        }
    }

    /// <summary>Bytes so far that belong to no intact record. Any thread.</summary>
    public long BytesLost
    {
        get
        {
            lock (_gate)
                return _reader.LostBytes;
        }
    }

    /// <summary>
    /// Intact records so far whose frame has an incompatibility flag that is not known, so that it had to be left out.
    /// Any thread.
    /// </summary>
    public long IncompatibleFrames
    {
        get
        {
            lock (_gate)
                return _reader.IncompatibleRecords;
        }
    }

    /// <summary>
    /// Frames so far whose trailing zeros the recorder had cut off, and that are as they were sent again. Any thread.
    /// </summary>
    public long MendedFrames
    {
        get
        {
            lock (_gate)
                return _reader.MendedRecords;
        }
    }

    /// <summary>
    /// Whole records so far whose frame was refused, by message id: the message of that id is another one. Any thread.
    /// </summary>
    public IReadOnlyDictionary<int, long> RefusedFrames
    {
        get
        {
            lock (_gate)
                return _reader.RefusedRecordsById.ToDictionary(r => r.Key, r => r.Value);
        }
    }

    /// <summary>File offset of the first lost byte; null while there is none. Any thread.</summary>
    public long? FirstDamageOffset
    {
        get
        {
            lock (_gate)
                return _reader.FirstDamageOffset;
        }
    }

    /// <summary>Opens a log and reads up to its first record.</summary>
    /// <param name="url">Of kind <see cref="LinkKind.RecordedFile"/>.</param>
    /// <param name="dialect">
    /// The messages whose checksum can be checked; null for <see cref="MavlinkDialect.All"/>.
    /// </param>
    /// <exception cref="LinkException">
    /// There is no such file, it may not be read, or it has no intact record.
    /// </exception>
    public static RecordedFile Open(LinkUrl url, MavlinkDialect? dialect = null)
    {
        if (url is null || url.Kind != LinkKind.RecordedFile)
            throw new ArgumentException("A recorded file is opened by a tlog: link.", nameof(url));

        FileStream stream = OpenStream(url);
        try
        {
            if (!stream.CanSeek)
                throw new LinkException(url.ToString(), "that is no file: its length is not known", linkEnded: true);
            var file = new RecordedFile(url, stream, dialect ?? MavlinkDialect.All);
            if (file._holdsFirst)
                return file;
            string reason = file.Length == 0 ? "the file is empty" : "no intact record in it: it is no telemetry log";
            throw new LinkException(url.ToString(), reason, linkEnded: true);
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    /// <summary>Reads the next intact record.</summary>
    /// <param name="frame">Its frame.</param>
    /// <param name="record">Its number, place and stamp.</param>
    /// <returns>False at the end of the file.</returns>
    /// <exception cref="LinkException">The file could not be read on.</exception>
    public bool TryRead(out MavlinkFrame frame, out TlogRecord record)
    {
        lock (_gate)
        {
            if (_holdsFirst)
            {
                _holdsFirst = false;
                frame = _firstFrame;
                record = _firstRecord;
                return true;
            }

            return TryReadRecord(out frame, out record);
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose() => _stream.Dispose();

    private bool TryReadRecord(out MavlinkFrame frame, out TlogRecord record)
    {
        try
        {
            return _reader.TryRead(out frame, out record);
        }
        catch (IOException e)
        {
            throw new LinkException(Url.ToString(), "the file cannot be read: " + e.Message, linkEnded: true, e);
        }
    }

    private static FileStream OpenStream(LinkUrl url)
    {
        try
        {
            return new FileStream(url.Path!, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            string reason = e switch
            {
                FileNotFoundException or DirectoryNotFoundException => "no such file",
                UnauthorizedAccessException =>
                    Directory.Exists(url.Path!) ? "that is a folder" : "no permission to read it",
                _ => e.Message,
            };
            throw new LinkException(url.ToString(), reason, linkEnded: true, e);
        }
    }
}
