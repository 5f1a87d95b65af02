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
/// The time of a picture is that of its arrival less <see cref="ProcessCameraOptions.Latency"/> and its exposure.
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
public sealed class ProcessCamera : IReaderSource<CameraFrame>
{
    private const int ChunkBytes = 65_536;

    private readonly ProcessCameraOptions _options;
    private readonly BufferPool _pool;
    private readonly JpegDecoder _jpeg = new();
    private readonly int _maxBytes;
    private byte[] _bytes;
    private int _filled;
    private ReaderContext? _context;
    private ChildProcess? _process;
    private ITimer? _stall;
    private TimeSpan _restartAt;
    private TimeSpan _delay;
    private long _number;
    private long _delivered;
    private long _refused;
    private long _skipped;
    private long _withoutBuffer;
    private long _restarts;
    private string? _lastFault;
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

        // No JPEG of a camera is larger than its pixels.
        int picture = _options.Format == ProcessCameraFormat.Mjpeg
            ? (_options.Width * _options.Height * 3) + ChunkBytes
            : Yuv420.BytesOf(_options.Width, _options.Height);
        _maxBytes = picture + ChunkBytes;
        _bytes = new byte[Math.Min(_maxBytes, picture / 4 + (2 * ChunkBytes))];
    }

    /// <inheritdoc/>
    public bool Blocks => true;

    /// <summary>Pictures delivered.</summary>
    public long PicturesDelivered => Interlocked.Read(ref _delivered);

    /// <summary>Pictures that could not be decoded, or have another size than the camera's.</summary>
    public long PicturesRefused => Interlocked.Read(ref _refused);

    /// <summary>Pictures that were not decoded because a newer one had come.</summary>
    public long PicturesSkipped => Interlocked.Read(ref _skipped);

    /// <summary>Pictures lost because no buffer was free.</summary>
    public long PicturesWithoutBuffer => Interlocked.Read(ref _withoutBuffer);

    /// <summary>How often the program was started again.</summary>
    public long Restarts => Interlocked.Read(ref _restarts);

    /// <summary>What went wrong last, one line; null if nothing did.</summary>
    public string? LastFault => Volatile.Read(ref _lastFault);

    /// <inheritdoc/>
    public void Open(ReaderContext context)
    {
        _context = context ?? throw new ArgumentNullException(nameof(context));
        _delay = _options.FirstRestartDelay;
        Start();
    }

    /// <inheritdoc/>
    public ReaderStep Read(out CameraFrame value)
    {
        value = default;
        while (!_isStopping)
        {
            if (_process is null && !TryRestart())
                return ReaderStep.WaitUntil(_restartAt);
            if (TryTakeNewest(out value))
            {
                _delay = _options.FirstRestartDelay;
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
        _filled = 0;
        _isStalled = false;
        Volatile.Write(ref _process, new ChildProcess(
            _options.Program, _options.Arguments, line => _options.Log?.Invoke($"{_options.Program}: {line}")));
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
        if (_context!.Now < _restartAt)
            return false;
        Interlocked.Increment(ref _restarts);
        try
        {
            Start();
            return true;
        }
        catch (IOException e)
        {
            Fail(e.Message);
            return false;
        }
    }

    private void ReadMore()
    {
        if (_bytes.Length - _filled < ChunkBytes && _bytes.Length < _maxBytes)
            Array.Resize(ref _bytes, Math.Min(_maxBytes, _bytes.Length * 2));
        if (_filled == _bytes.Length)
        {
            // No end of a picture in more bytes than one may have.
            Refuse("no end of a picture came");
            _filled = 0;
        }

        int read = 0;
        try
        {
            read = _process!.Output.Read(_bytes, _filled, _bytes.Length - _filled);
        }
        catch (Exception e) when (e is IOException or ObjectDisposedException)
        {
            // It was killed.
        }

        if (read > 0)
        {
            _filled += read;
            _stall!.Change(_options.StallTimeout, Timeout.InfiniteTimeSpan);
        }
        else if (!_isStopping)
        {
            Fail(_isStalled
                ? FormattableString.Invariant($"it wrote nothing for {_options.StallTimeout.TotalSeconds} s")
                : _process!.DescribeEnd());
        }
    }

    private void Fail(string reason)
    {
        End();
        _restartAt = _context!.Now + _delay;
        string text = FormattableString.Invariant(
            $"{_options.Program}: {reason}; it is started again in {_delay.TotalSeconds} s");
        Volatile.Write(ref _lastFault, text);
        _options.Log?.Invoke(text);
        _delay = _delay + _delay < _options.MaxRestartDelay ? _delay + _delay : _options.MaxRestartDelay;
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
        while (TryFind(used, out int nextStart, out int nextLength, out int keep))
        {
            if (length > 0)
                Skip();
            (start, length, used) = (nextStart, nextLength, keep);
        }

        bool isTaken = length > 0 && TryDecode(start, length, out frame);
        TryFind(used, out _, out _, out int needed);
        _filled -= needed;
        Buffer.BlockCopy(_bytes, needed, _bytes, 0, _filled);
        return isTaken;
    }

    private bool TryFind(int from, out int start, out int length, out int keep)
    {
        if (_options.Format == ProcessCameraFormat.Mjpeg)
        {
            bool isFound = JpegStream.TryFind(_bytes, from, _filled - from, out start, out length);
            keep = start + length;
            return isFound;
        }

        (start, length) = (from, Yuv420.BytesOf(_options.Width, _options.Height));
        bool isWhole = _filled - from >= length;
        keep = isWhole ? from + length : from;
        return isWhole;
    }

    private bool TryDecode(int start, int length, out CameraFrame frame)
    {
        frame = default;
        long number = _number++;
        if (!_pool.TryRent("process camera", out BufferLease lease))
        {
            Interlocked.Increment(ref _withoutBuffer);
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

        Interlocked.Increment(ref _delivered);
        frame = new CameraFrame
        {
            Pixels = lease,
            Width = _options.Width,
            Height = _options.Height,
            Number = number,
            FrameStart = _context!.Now - _options.Latency - _options.Exposure,
            Exposure = _options.Exposure,
        };
        return true;
    }

    private void DecodeInto(byte[] pixels, int start, int length)
    {
        if (_options.Format != ProcessCameraFormat.Mjpeg)
        {
            bool isFullRange = _options.Format == ProcessCameraFormat.Yuv420FullRange;
            Yuv420.ToRgb(_bytes, start, _options.Width, _options.Height, isFullRange, pixels);
            return;
        }

        _jpeg.Open(_bytes, start, length, _options.Program);
        if (_jpeg.Width != _options.Width || _jpeg.Height != _options.Height)
            throw new PictureException(
                _options.Program,
                $"a picture is {_jpeg.Width} x {_jpeg.Height}; {_options.Width} x {_options.Height} are wanted");
        _jpeg.Decode(pixels);
    }

    private void Skip()
    {
        _number++;
        Interlocked.Increment(ref _skipped);
    }

    private void Refuse(string reason)
    {
        Interlocked.Increment(ref _refused);
        Volatile.Write(ref _lastFault, $"{_options.Program}: {reason}");
    }
}
