using System;
using System.IO;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A camera that is the standard output of another program, as <c>rpicam-vid</c> and <c>ffmpeg</c> write it. The
/// program is ended with this one, and started again, after a delay that doubles, when it ends or gives no picture that
/// can be used for too long; Health Monitoring sees a camera without pictures meanwhile. An end with which a stop of
/// the run is requested is no fault: Ctrl-C in a terminal, or a service that is stopped, ends both. It needs real time.
/// The figures may be read from any thread.
/// </summary>
/// <remarks>
/// The time of a picture is that of its arrival less <see cref="ProcessCameraOptions.Latency"/> and its exposure; or,
/// where <c>{metadata}</c> stands in <see cref="ProcessCameraOptions.Arguments"/>, that of the sensor. A program that
/// cannot be started is a fault of the camera, which is tried again in the same way.
/// </remarks>
/// <example>
/// <code>
/// var camera = new ProcessCamera(new ProcessCameraOptions
/// {
///     Program = "rpicam-vid",
///     Arguments = ["-t", "0", "-n", "--codec", "mjpeg", "--width", "1640", "--height", "1232", "-o", "-"],
///     Width = 1640,
///     Height = 1232,
/// });
/// </code>
/// </example>
public sealed partial class ProcessCamera : ICamera
{
    private readonly ProcessCameraOptions _options;
    private readonly BufferPool _pool;
    private readonly ProcessPictures _stream;
    private readonly ProcessPictureTimes? _times;   // null: by arrival
    private readonly CameraPictures _pictures;
    private readonly RowLengthCheck _rows;
    private readonly PictureRate _rate;
    private readonly RestartDelay _delay;
    private readonly CameraJournal _journal;
    private readonly LineLimit _lines;
    private readonly string _ofArrival;
    private readonly string _ofMetadata;
    private ReaderContext? _context;
    private ChildProcess? _process;
    private ITimer? _stall;
    private TimeSpan _arrived;
    private TimeSpan _frameStart;
    private TimeSpan _exposure;
    private TimeSpan _timeNoise;
    private string _timeSource;
    private bool _isTimeKnown = true;
    private bool _hasBytes;   // since the last whole picture
    private string? _end;     // how the program ended, while that may still be the end that was asked for
    private TimeSpan _endIsFaultAt;
    private long _number;
    private volatile bool _isStalled;
    private volatile bool _isStopping;

    /// <summary>Makes the camera; the program is started when the run begins.</summary>
    /// <param name="options">The program and its pictures; read now.</param>
    /// <exception cref="ArgumentException">An option is out of its range.</exception>
    public ProcessCamera(ProcessCameraOptions options)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        _pool = new BufferPool(
            "camera " + _options.Program, _options.Buffers, _options.Width * _options.Height * 3);

        _stream = new ProcessPictures(_options);
        _times = _options.HasMetadata ? new ProcessPictureTimes(_options) : null;
        _pictures = new CameraPictures(_options.Program, _options.Width, _options.Height);
        _rows = new RowLengthCheck(_options);
        _rate = new PictureRate(_options.MaxFramesPerSecond);
        _delay = new RestartDelay(_options.FirstRestartDelay, _options.MaxRestartDelay);
        _journal = new CameraJournal(_options.Program);
        _lines = new LineLimit(Log);
        _ofArrival = PictureTimeSource.OfArrival(_options.Latency, _options.TimeNoise);
        _ofMetadata = PictureTimeSource.Describe("the program's metadata", _options.MetadataTimeNoise);
        _timeSource = _ofArrival;
    }

    /// <inheritdoc/>
    public bool Blocks => true;

    /// <inheritdoc/>
    public string Name => _options.Program;

    /// <inheritdoc/>
    public CameraStatistics Statistics => _journal.Statistics;

    /// <summary>Pictures delivered.</summary>
    public long PicturesDelivered => Statistics.Delivered;

    /// <summary>Pictures that could not be decoded, or have another size than the camera's.</summary>
    public long PicturesRefused => Statistics.Refused;

    /// <summary>
    /// Pictures that were not decoded because a newer one had come, or more come than are wanted.
    /// </summary>
    public long PicturesSkipped => Statistics.Skipped;

    /// <summary>Pictures lost because no buffer was free.</summary>
    public long PicturesWithoutBuffer => Statistics.WithoutBuffer;

    /// <summary>How often the program was started again, or it was tried.</summary>
    public long Restarts => Statistics.Restarts;

    /// <summary>What went wrong last, one line; null if nothing did.</summary>
    public string? LastFault => Statistics.LastFault;

    /// <inheritdoc/>
    public void LogTo(Action<string>? log) => _journal.LogTo(log);

    /// <inheritdoc/>
    public void Open(ReaderContext context)
    {
        _context = context ?? throw new ArgumentNullException(nameof(context));
        _delay.Reset();
        if (_options.Format == ProcessCameraFormat.Mjpeg)
            Log($"{_options.Program}: {_pictures.EngineText}");
        TryStart();
    }

    /// <inheritdoc/>
    public ReaderStep Read(out CameraFrame value)
    {
        value = default;
        while (!_isStopping)
        {
            if (_process is null && IsToWait(out ReaderStep wait))
                return wait;
            if (TryTakeNewest(out value))
            {
                _delay.Reset();
                return ReaderStep.Value;
            }

            if (_process is not null)
                ReadMore();
        }

        return ReaderStep.Ended;
    }

    /// <inheritdoc/>
    public void Unblock()
    {
        _isStopping = true;
        Volatile.Read(ref _process)?.Kill();
    }

    /// <inheritdoc/>
    public void Close() => End();

    private void ReadMore()
    {
        if (_stream.IsFull)
        {
            // No end of a picture in more bytes than one may have.
            Refuse("no end of a picture came");
            _stream.Clear();
            _times?.Lose();
        }

        if (_stream.ReadFrom(_process!.Output) > 0)
        {
            _arrived = _context!.Now;
            _hasBytes = true;
        }
        else if (!_isStopping && _isStalled)
        {
            string seconds = FormattableString.Invariant($"for {_options.StallTimeout.ExactSeconds} s");
            Fail(
                _hasBytes
                    ? $"it wrote no whole picture {seconds}, only bytes that are none"
                    : $"it wrote nothing {seconds}",
                "it is started again");
        }
        else if (!_isStopping)
        {
            _end = _process!.DescribeEnd();
            _endIsFaultAt = _context!.Now + _options.EndGrace;
            End();
        }
    }

    // Older pictures that are whole were not asked for in time.
    private bool TryTakeNewest(out CameraFrame frame)
    {
        frame = default;
        (int start, int length, int used) = (0, 0, 0);
        while (_stream.TryFind(used, out int nextStart, out int nextLength, out int keep))
        {
            if (length > 0)
                Skip();
            _times?.Count();
            (start, length, used) = (nextStart, nextLength, keep);
        }

        if (length > 0)
            RestartStallTimer();
        bool isTaken = length > 0 && TryFindTime() && IsWanted() && TryDecode(start, length, out frame);
        _stream.TryFind(used, out _, out _, out int needed);
        _stream.DropBefore(needed);
        return isTaken;
    }

    // Of the picture that came last, also of one that is not wanted: else the program would wait for its reader.
    private bool TryFindTime()
    {
        (_exposure, _timeNoise, _timeSource) = (_options.Exposure, _options.TimeNoise, _ofArrival);
        _frameStart = _arrived - _options.Latency - _exposure;
        if (_times is null)
            return true;
        TimeSpan start;
        TimeSpan exposure;
        bool isKnown;
        try
        {
            isKnown = _times.TryGet(_arrived, _context!, out start, out exposure);
        }
        catch (IOException e)
        {
            Fail(e.Message, "it is started again");
            return false;
        }

        if (_isStalled)
        {
            Fail(FormattableString.Invariant(
                $"it wrote no metadata for {_options.StallTimeout.ExactSeconds} s"), "it is started again");
            return false;
        }

        if (isKnown)
        {
            (_frameStart, _exposure) = (start, exposure);
            (_timeNoise, _timeSource) = (_options.MetadataTimeNoise, _ofMetadata);
        }
        else
        {
            _journal.MissTime();
        }

        if (!isKnown && _isTimeKnown && !_isStopping)
            Log($"{_options.Program}: no time of a picture in its metadata; that of the arrival is taken");
        _isTimeKnown = isKnown;
        return true;
    }

    private bool IsWanted()
    {
        bool isWanted = _rate.Takes(_arrived);
        if (!isWanted)
            Skip();
        return isWanted;
    }

    private bool TryDecode(int start, int length, out CameraFrame frame)
    {
        frame = default;
        long number = _number++;
        if (!_pool.TryRent("process camera", out BufferLease lease))
        {
            _journal.MissBuffer();
            return false;
        }

        try
        {
            DecodeInto(lease.Array, start, length);
        }
        catch (PictureException e)
        {
            lease.Dispose();
            RefuseWhole(e.Reason);
            return false;
        }

        _journal.Deliver(_timeSource);
        frame = new CameraFrame
        {
            Pixels = lease,
            Width = _options.Width,
            Height = _options.Height,
            Format = _options.Format == ProcessCameraFormat.Grey16 ? PixelFormat.Grey16 : PixelFormat.Rgb24,
            Number = number,
            FrameStart = _frameStart,
            Exposure = _exposure,
            TimeNoise = _timeNoise,
        };
        return true;
    }

    private void DecodeInto(byte[] pixels, int start, int length)
    {
        if (_options.Format == ProcessCameraFormat.Mjpeg)
            _pictures.DecodeJpeg(_stream.Bytes, start, length, pixels);
        else
            CopyRaw(pixels, start);
    }

    private void CopyRaw(byte[] pixels, int start)
    {
        if (_rows.Look(_stream.Bytes, start) is { } line)
            Log(line);
        int length = _stream.RemovePadding(start);
        if (_options.Format == ProcessCameraFormat.Grey16)
            Buffer.BlockCopy(_stream.Bytes, start, pixels, 0, length);
        else
            _pictures.ConvertYuv420(
                _stream.Bytes, start, _options.Format == ProcessCameraFormat.Yuv420FullRange, pixels);
    }

    // What is left out because no more are wanted is no loss, and leaves no gap in the numbers.
    private void Skip()
    {
        if (!_rate.IsLimited)
            _number++;
        _journal.Skip();
    }

    private void RefuseWhole(string reason)
    {
        Refuse(reason);
        if (_journal.FindOnlyRefused(reason, _arrived, _options.StallTimeout) is { } fault)
            Fail(fault, "it is started again");
    }

    private void Refuse(string reason)
    {
        if (_journal.Refuse(reason) is { } line)
            _lines.Add(line, _context!.Now);
    }
}
