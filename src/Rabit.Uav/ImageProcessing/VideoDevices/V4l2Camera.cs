using System;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.ImageProcessing.VideoDevices;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A video device of Linux (Video4Linux 2), as USB cameras are. A device that is missing, in use, unplugged or gives
/// for too long nothing, or only pictures that cannot be used, is a fault of the camera; it is opened again after a
/// delay that doubles, and Health Monitoring sees a camera without pictures meanwhile. It needs real time. The figures
/// may be read from any thread.
/// </summary>
/// <remarks>
/// The time of a picture is that of the driver, where it takes one of the clock that only goes forward: the start of
/// the exposure, or the end of the picture, which is later by readout and exposure. Else it is that of its arrival less
/// <see cref="V4l2CameraOptions.Latency"/> and the exposure. Nothing is allocated for a picture after the first.
/// </remarks>
/// <example>
/// <code>
/// var camera = new V4l2Camera(new V4l2CameraOptions
/// {
///     Device = "/dev/video0",
///     Width = 1280,
///     Height = 720,
///     FramesPerSecond = 5,
///     Exposure = TimeSpan.FromMilliseconds(2),
/// });
/// </code>
/// </example>
public sealed class V4l2Camera : ICamera
{
    // A stop is noticed so soon.
    private const int WaitMilliseconds = 50;

    private static readonly TimeSpan ArrivalLatency = TimeSpan.FromMilliseconds(50);
    private static readonly TimeSpan StampNoise = TimeSpan.FromMilliseconds(5);
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private readonly V4l2CameraOptions _options;
    private readonly IVideoSystem _system;
    private readonly BufferPool _pool;
    private readonly CameraPictures _pictures;
    private readonly PictureRate _rate;
    private readonly RestartDelay _delay;
    private readonly CameraJournal _journal;
    private readonly TimeSpan _stampNoise;
    private readonly TimeSpan _arrivalNoise;
    private readonly string _ofStamp;
    private readonly string _ofArrival;
    private byte[] _bytes = [];
    private ReaderContext? _context;
    private V4l2Device? _device;
    private TimeSpan _lastBuffer;
    private uint? _lastSequence;
    private long _number = -1;
    private volatile bool _isStopping;

    /// <summary>Makes the camera; the device is opened when the run begins.</summary>
    /// <param name="options">The device and its pictures; read now.</param>
    /// <exception cref="ArgumentException">An option is out of its range.</exception>
    public V4l2Camera(V4l2CameraOptions options)
        : this(options, new LinuxVideoSystem(), OperatingSystem.IsLinux())
    {
    }

    internal V4l2Camera(V4l2CameraOptions options, IVideoSystem system, bool isLinux = true)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        if (!isLinux)
            throw new ArgumentException(
                $"The camera {options.Device}: video devices are read on Linux only.", nameof(options));
        _system = system;
        _journal = new CameraJournal(_options.Device);
        _pool = new BufferPool("camera " + _options.Device, _options.Buffers, _options.Width * _options.Height * 3);
        _pictures = new CameraPictures(_options.Device, _options.Width, _options.Height);
        _rate = new PictureRate(_options.FramesPerSecond);
        _delay = new RestartDelay(_options.FirstRestartDelay, _options.MaxRestartDelay);
        TimeSpan least = PictureTimeSource.MinArrivalNoise;
        _stampNoise = _options.TimeNoise ?? StampNoise;
        _arrivalNoise = _options.TimeNoise is { } noise && noise > least ? noise : least;
        _ofStamp = PictureTimeSource.Describe("time of the driver", _stampNoise);
        _ofArrival = PictureTimeSource.OfArrival(_options.Latency ?? ArrivalLatency, _arrivalNoise);
    }

    /// <inheritdoc/>
    public bool Blocks => true;

    /// <inheritdoc/>
    public string Name => _options.Device;

    /// <inheritdoc/>
    public CameraStatistics Statistics => _journal.Statistics;

    /// <inheritdoc/>
    public void LogTo(Action<string>? log) => _journal.LogTo(log);

    /// <inheritdoc/>
    public void Open(ReaderContext context)
    {
        _context = context ?? throw new ArgumentNullException(nameof(context));
        _delay.Reset();
        if (_options.Format == V4l2PixelFormat.Mjpeg)
            _journal.Log(_pictures.EngineText);
        TryOpen();
    }

    /// <inheritdoc/>
    public ReaderStep Read(out CameraFrame value)
    {
        value = default;
        while (!_isStopping)
        {
            if (_device is null && !TryOpenAgain())
                return ReaderStep.WaitUntil(_delay.Due);
            try
            {
                if (_device!.Wait(WaitMilliseconds) && TryTake(_device, out value))
                {
                    _delay.Reset();
                    return ReaderStep.Value;
                }

                if (_context!.Now - _lastBuffer > _options.StallTimeout)
                    Fail(FormattableString.Invariant($"it gave no picture for {_options.StallTimeout.ExactSeconds} s"));
            }
            catch (VideoDeviceException e)
            {
                Fail(e.Message);
            }
        }

        return ReaderStep.Ended;
    }

    /// <inheritdoc/>
    public void Unblock() => _isStopping = true;

    /// <inheritdoc/>
    public void Close() => End();

    private bool TryOpenAgain()
    {
        if (_context!.Now < _delay.Due)
            return false;
        _journal.Restart();
        return TryOpen();
    }

    private bool TryOpen()
    {
        try
        {
            _device = new V4l2Device(_system, _options);
            (_lastBuffer, _lastSequence) = (_context!.Now, null);
            _journal.Begin();
            if (_bytes.Length < _device.MaxBytes)
                _bytes = new byte[_device.MaxBytes];
            _journal.Log(_device.Card);
            foreach (string missing in _device.Controls.Missing)
                _journal.Log($"it has no control of its {missing}");
            return true;
        }
        catch (VideoDeviceException e)
        {
            Fail(e.Message);
            return false;
        }
    }

    private void Fail(string reason)
    {
        End();
        string fault = _journal.Fail(reason);
        TimeSpan delay = _delay.Begin(_context!.Now);
        _journal.WriteLine(FormattableString.Invariant($"{fault}; it is opened again in {delay.ExactSeconds} s"));
    }

    private void End()
    {
        _device?.Close();
        _device = null;
    }

    // Older ones were not asked for in time.
    private bool TryTake(V4l2Device device, out CameraFrame frame)
    {
        frame = default;
        if (!device.TryDequeue(out V4l2Buffer newest))
            return false;
        while (device.TryDequeue(out V4l2Buffer next))
        {
            device.Queue(newest.Index);
            _journal.Skip();
            newest = next;
        }

        TimeSpan now = _context!.Now;
        long monotonic = _system.MonotonicMicroseconds();
        _lastBuffer = now;
        if (!_rate.Takes(now))
        {
            device.Queue(newest.Index);
            _journal.Skip();
            return false;
        }

        Count(newest.Sequence);
        return TryDecode(device, newest, now, monotonic, out frame);
    }

    // A gap in the driver's numbers is a picture that was lost, unless no more are wanted.
    private void Count(uint sequence)
    {
        uint step = _lastSequence is { } last ? unchecked(sequence - last) : 1;
        _number += _rate.IsLimited || step is 0 or > int.MaxValue ? 1 : step;
        _lastSequence = sequence;
    }

    private bool TryDecode(
        V4l2Device device, in V4l2Buffer buffer, TimeSpan now, long monotonic, out CameraFrame frame)
    {
        frame = default;
        bool isRented = _pool.TryRent("video device", out BufferLease lease);
        try
        {
            if (isRented)
                device.Copy(buffer, _bytes);
            device.Queue(buffer.Index);
            if (!isRented)
            {
                _journal.MissBuffer();
                return false;
            }

            Decode(device, buffer, lease.Array);
        }
        catch (PictureException e)
        {
            lease.Dispose();
            Refuse(e.Reason, now);
            return false;
        }
        catch (VideoDeviceException)
        {
            if (isRented)
                lease.Dispose();
            throw;
        }

        frame = Stamp(device, buffer, now, monotonic, out bool isStamped);
        frame.Pixels = lease;
        _journal.Deliver(isStamped ? _ofStamp : _ofArrival);
        return true;
    }

    private void Decode(V4l2Device device, in V4l2Buffer buffer, byte[] pixels)
    {
        if (buffer.IsDamaged)
            throw new PictureException(_options.Device, "the driver says that a picture is damaged");
        if (_options.Format == V4l2PixelFormat.Mjpeg)
            _pictures.DecodeJpeg(_bytes, 0, buffer.Bytes, pixels);
        else if (buffer.Bytes < ((long)device.RowBytes * (_options.Height - 1)) + (_options.Width * 2))
            throw new PictureException(_options.Device, "a part of a picture is missing");
        else
            Yuyv.ToRgb(_bytes, 0, device.RowBytes, _options.Width, _options.Height, device.IsFullRange, pixels);
    }

    private CameraFrame Stamp(
        V4l2Device device, in V4l2Buffer buffer, TimeSpan now, long monotonic, out bool isStamped)
    {
        TimeSpan exposure = device.Controls.Exposure;
        TimeSpan age = TimeSpan.FromTicks(
            (monotonic - buffer.StampMicroseconds) * PictureFolderWriter.TicksPerMicrosecond);
        isStamped = buffer.IsStamped && age >= TimeSpan.Zero && age < MaxAge;
        TimeSpan latency = _options.Latency ?? (isStamped ? TimeSpan.Zero : ArrivalLatency);
        TimeSpan start = (isStamped ? now - age : now) - latency;
        if (!isStamped)
            start -= exposure;
        else if (!buffer.IsStartOfExposure)
            start -= exposure + _options.Readout;
        return new CameraFrame
        {
            Width = _options.Width,
            Height = _options.Height,
            Number = _number,
            FrameStart = start,
            Exposure = exposure,
            TimeNoise = isStamped ? _stampNoise : _arrivalNoise,
        };
    }

    private void Refuse(string reason, TimeSpan now)
    {
        if (_journal.Refuse(reason) is { } line)
            _journal.WriteLine(line);
        if (_journal.FindOnlyRefused(reason, now, _options.StallTimeout) is { } fault)
            Fail(fault);
    }
}
