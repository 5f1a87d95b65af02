using System;
using System.IO;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A camera that is the standard output of another program, as <c>rpicam-vid</c> and <c>ffmpeg</c> write it. The
/// program is ended with this one, and started again, after a delay that doubles, when it ends or writes nothing for
/// too long; Health Monitoring sees a camera without pictures meanwhile. It needs real time. The figures may be read
/// from any thread.
/// </summary>
/// <remarks>
/// The time of a picture is that of its arrival less <see cref="ProcessCameraOptions.Latency"/> and its exposure. A
/// program that cannot be started is a fault of the camera, which is tried again in the same way.
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
public sealed class ProcessCamera : ICamera
{
    private readonly ProcessCameraOptions _options;
    private readonly BufferPool _pool;
    private readonly ProcessPictures _stream;
    private readonly CameraPictures _pictures;
    private readonly PictureRate _rate;
    private readonly RestartDelay _delay;
    private readonly CameraJournal _journal;
    private readonly LineLimit _lines;
    private ReaderContext? _context;
    private ChildProcess? _process;
    private ITimer? _stall;
    private TimeSpan _arrived;
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
        _pictures = new CameraPictures(_options.Program, _options.Width, _options.Height);
        _rate = new PictureRate(_options.MaxFramesPerSecond);
        _delay = new RestartDelay(_options.FirstRestartDelay, _options.MaxRestartDelay);
        _journal = new CameraJournal(_options.Program);
        _lines = new LineLimit(Log);
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
            if (_process is null && !TryRestart())
                return ReaderStep.WaitUntil(_delay.Due);
            if (TryTakeNewest(out value))
            {
                _delay.Reset();
                return ReaderStep.Value;
            }

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

    private void Start()
    {
        _stream.Clear();
        _isStalled = false;
        Volatile.Write(ref _process, new ChildProcess(
            _options.Program,
            _options.Arguments,
            line => _lines.Add($"{_options.Program}: {line}", _context!.Now)));
        _stall = _context!.Clock.CreateTimer(
            _ => OnStall(), null, _options.StallTimeout, Timeout.InfiniteTimeSpan);

        // Unblock may have looked before there was a process.
        if (_isStopping)
            _process!.Kill();
    }

    private void OnStall()
    {
        _isStalled = true;
        Volatile.Read(ref _process)?.Kill();
    }

    private bool TryRestart()
    {
        if (_context!.Now < _delay.Due)
            return false;
        _journal.Restart();
        return TryStart();
    }

    private bool TryStart()
    {
        try
        {
            Start();
            return true;
        }
        catch (IOException e)
        {
            Fail(e.Message, "it is tried again");
            return false;
        }
    }

    private void ReadMore()
    {
        if (_stream.IsFull)
        {
            // No end of a picture in more bytes than one may have.
            Refuse("no end of a picture came");
            _stream.Clear();
        }

        if (_stream.ReadFrom(_process!.Output) > 0)
        {
            _arrived = _context!.Now;
            _stall!.Change(_options.StallTimeout, Timeout.InfiniteTimeSpan);
        }
        else if (!_isStopping)
        {
            Fail(_isStalled
                ? FormattableString.Invariant($"it wrote nothing for {_options.StallTimeout.TotalSeconds} s")
                : _process!.DescribeEnd(), "it is started again");
        }
    }

    private void Fail(string reason, string next)
    {
        End();
        string fault = _journal.Fail(reason);
        TimeSpan delay = _delay.Begin(_context!.Now);
        Log(FormattableString.Invariant($"{fault}; {next} in {delay.TotalSeconds} s"));
    }

    private void Log(string line)
    {
        _options.Log?.Invoke(line);
        _journal.WriteLine(line);
    }

    private void End()
    {
        _stall?.Dispose();
        _stall = null;
        _process?.Dispose();
        Volatile.Write(ref _process, null);
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
            (start, length, used) = (nextStart, nextLength, keep);
        }

        bool isTaken = length > 0 && IsWanted() && TryDecode(start, length, out frame);
        _stream.TryFind(used, out _, out _, out int needed);
        _stream.DropBefore(needed);
        return isTaken;
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
            Refuse(e.Reason);
            return false;
        }

        _journal.Deliver();
        frame = new CameraFrame
        {
            Pixels = lease,
            Width = _options.Width,
            Height = _options.Height,
            Format = _options.Format == ProcessCameraFormat.Grey16 ? PixelFormat.Grey16 : PixelFormat.Rgb24,
            Number = number,
            FrameStart = _arrived - _options.Latency - _options.Exposure,
            Exposure = _options.Exposure,
            TimeNoise = _options.TimeNoise,
        };
        return true;
    }

    private void DecodeInto(byte[] pixels, int start, int length)
    {
        if (_options.Format == ProcessCameraFormat.Mjpeg)
            _pictures.DecodeJpeg(_stream.Bytes, start, length, pixels);
        else if (_options.Format == ProcessCameraFormat.Grey16)
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

    private void Refuse(string reason)
    {
        if (_journal.Refuse(reason) is { } line)
            _lines.Add(line, _context!.Now);
    }
}
