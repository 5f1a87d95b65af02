using System;
using System.IO;
using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Writes frames to telemetry logs, on the writer's thread. It never throws: while the disk fails frames are counted as
/// lost, and it tries again once a second. Each record goes to the system at once, so that a program that ends, however
/// it does, leaves a whole log; a record that was written in part is cut off again. Any thread may read the figures.
/// </summary>
internal sealed class FrameRecorder(RecordingOptions options) : IWriterTarget<FrameToRecord>
{
    private const int TimeLength = 8;

    // 2100-01-01 UTC, as far as records go.
    private const long LastMicroseconds = 4_102_444_800_000_000;

    // Readers of several links and our own sending are a little out of order; a clock that was set has moved by more.
    private const long MaxDisorderMicroseconds = 1_000_000;

    private static readonly TimeSpan RetryPeriod = TimeSpan.FromSeconds(1);

    private readonly RecordingFiles _files = new(options);
    private Stream? _stream;
    private TlogWriter? _log;
    private long _length;
    private long _lastMicroseconds;
    private TimeSpan _failedAt;
    private bool _isFailing;
    private long _frames;
    private long _bytes;
    private long _lost;
    private volatile string? _fault;

    public bool Blocks => false;

    public long Frames => Interlocked.Read(ref _frames);

    public long Bytes => Interlocked.Read(ref _bytes);

    /// <summary>Frames that could not be written.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    /// <summary>Why the last one could not; null while all goes well.</summary>
    public string? Fault => _fault;

    public string? File => _files.Current;

    public int FileCount => _files.Count;

    public int FilesDeleted => _files.Deleted;

    public void Open()
    {
    }

    public void Write(in FrameToRecord value)
    {
        if (_isFailing && value.Time - _failedAt < RetryPeriod)
        {
            Interlocked.Increment(ref _lost);
            return;
        }

        try
        {
            Record(value);
            (_isFailing, _fault) = (false, null);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or NotSupportedException or ObjectDisposedException)
        {
            Interlocked.Increment(ref _lost);
            (_isFailing, _failedAt, _fault) = (true, value.Time, e.Message);
            CutOff();
        }
    }

    /// <summary>A write that hangs in the system cannot be ended; what waits then is counted as dropped.</summary>
    public void Unblock()
    {
    }

    public void Close() => CloseFile();

    private void Record(in FrameToRecord value)
    {
        int length = TimeLength + value.Frame.WireLength;
        long time = Math.Min(LastMicroseconds, Math.Max(0, value.UtcMicroseconds));
        if (time < _lastMicroseconds && _lastMicroseconds - time < MaxDisorderMicroseconds)
            time = _lastMicroseconds;
        if (_stream is not null && _length + length > options.MaxFileBytes)
            CloseFile();
        if (_stream is null)
        {
            _stream = _files.CreateNext(time);
            _log = new TlogWriter(_stream);
            _length = 0;
        }

        if (!_log!.Write(time, value.Frame))
            return;
        _lastMicroseconds = time;
        _length += length;
        Interlocked.Increment(ref _frames);
        Interlocked.Add(ref _bytes, length);
    }

    // What a full disk took of a record would be damage in the middle of the log, once there is room again.
    private void CutOff()
    {
        if (_stream is null)
            return;
        try
        {
            _stream.SetLength(_length);
            _stream.Position = _length;
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or NotSupportedException or ObjectDisposedException)
        {
            CloseFile();
        }
    }

    private void CloseFile()
    {
        Stream? stream = _stream;
        (_stream, _log) = (null, null);
        try
        {
            stream?.Dispose();
            if (stream is not null && _length == 0)
                _files.DeleteEmpty();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            _fault = e.Message;
        }
    }
}
