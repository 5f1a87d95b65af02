using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The camera of the simulated vehicle: pictures of the ground and of what lies on it, as the true pose at the middle
/// of the exposure shows them, delivered some time after that. It never blocks: real time waits for a delivery,
/// virtual time jumps to it.
/// </summary>
/// <remarks>
/// The first exposure begins one period after the reader was opened. A picture that cannot be delivered, because the
/// camera is frozen, no buffer is free, the one before was not taken in time, or the truth of its moment is not
/// known, is lost, and its number with it. The figures may be read from any thread.
/// </remarks>
public sealed class SimulatedCamera : ICamera
{
    private const string Owner = "simulated camera";

    // Of the frames, whose TimeNoise is 0. A fault that shifts the time is one of which a camera does not know.
    private const string ExactTime = "clock of the simulation, standard deviation 0 ms";

    // The vehicle may be a step behind the moment that is asked for.
    private static readonly TimeSpan TruthPause = TimeSpan.FromMilliseconds(5);

    private readonly SimulatedCameraOptions _options;
    private readonly TruthHistory _truth;
    private readonly PictureRenderer _renderer;
    private readonly BufferPool _pool;
    private readonly PictureFaults _faults;
    private ReaderContext? _context;
    private ShownPicture _shown;
    private TimeSpan _opened;
    private long _number;
    private long _delivered;
    private long _frozen;
    private long _withoutBuffer;
    private long _overtaken;

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal SimulatedCamera(
        SimulatedCameraOptions options, TruthHistory truth, IEnumerable<SimulatedTarget> things, ulong seed,
        IReadOnlyList<ScriptedFault>? faults = null)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        _truth = truth;
        _renderer = new PictureRenderer(_options, things, seed);
        _faults = new PictureFaults(faults ?? Array.Empty<ScriptedFault>());
        _pool = new BufferPool(Owner, _options.Buffers, _options.Camera.Width * _options.Camera.Height * 3);
    }

    /// <inheritdoc/>
    public bool Blocks => false;

    /// <inheritdoc/>
    public string Name => Owner;

    /// <inheritdoc/>
    /// <remarks>
    /// A picture is skipped where the next one was due. Of one that is frozen it says nothing, as a real camera does.
    /// </remarks>
    public CameraStatistics Statistics => new()
    {
        Delivered = FramesDelivered,
        Skipped = FramesOvertaken,
        WithoutBuffer = FramesWithoutBuffer,
        TimeSource = ExactTime,
    };

    /// <summary>Pictures delivered.</summary>
    public long FramesDelivered => Interlocked.Read(ref _delivered);

    /// <summary>Pictures lost because the camera was frozen.</summary>
    public long FramesFrozen => Interlocked.Read(ref _frozen);

    /// <summary>Pictures lost because no buffer was free: they are kept too long, or not returned.</summary>
    public long FramesWithoutBuffer => Interlocked.Read(ref _withoutBuffer);

    /// <summary>
    /// Pictures lost because the next one was due before they could be made: none was requested, or the truth was not
    /// known.
    /// </summary>
    public long FramesOvertaken => Interlocked.Read(ref _overtaken);

    /// <summary>Who holds the buffers now, one name for each.</summary>
    public IReadOnlyList<string> BufferHolders() => _pool.Holders();

    /// <inheritdoc/>
    /// <remarks>It has nothing to say.</remarks>
    public void LogTo(Action<string>? log)
    {
    }

    /// <inheritdoc/>
    public void Open(ReaderContext context)
    {
        _context = context ?? throw new ArgumentNullException(nameof(context));
        _opened = context.Now;
    }

    /// <inheritdoc/>
    public ReaderStep Read(out CameraFrame value)
    {
        value = default;
        TimeSpan now = _context!.Now;
        for (; now >= DueTime(_number); _number++)
        {
            TimeSpan start = StartTime(_number);
            if (IsFrozen(start))
            {
                Interlocked.Increment(ref _frozen);
                continue;
            }

            if (now >= DueTime(_number + 1))
            {
                Interlocked.Increment(ref _overtaken);
                continue;
            }

            if (!TryGetCameraPose(start + Part(2), out CameraPose middle))
                return ReaderStep.WaitUntil(now + TruthPause);

            if (!_pool.TryRent(Owner, out BufferLease lease))
            {
                Interlocked.Increment(ref _withoutBuffer);
                continue;
            }

            value = Expose(start, middle, lease);
            _number++;
            Interlocked.Increment(ref _delivered);
            return ReaderStep.Value;
        }

        return ReaderStep.WaitUntil(DueTime(_number));
    }

    /// <inheritdoc/>
    public void Unblock()
    {
    }

    /// <inheritdoc/>
    public void Close()
    {
    }

    private CameraFrame Expose(TimeSpan start, in CameraPose middle, BufferLease lease)
    {
        _faults.Update(start, _number);
        if (!TryGetCameraPose(start + Part(1), out CameraPose early)
            || !TryGetCameraPose(start + Part(3), out CameraPose late))
            (early, late) = (middle, middle);
        if (!_faults.IsFrozen)
            _shown = new ShownPicture(middle, early, late, _number);
        long noise = _faults.HasNewNoise ? _number : _shown.Number;
        _renderer.Render(_shown.Middle, _shown.Early, _shown.Late, noise, lease.Array, _faults.Active);
        return new CameraFrame
        {
            Pixels = lease,
            Width = _options.Camera.Width,
            Height = _options.Camera.Height,
            Number = _faults.RepeatedNumber ?? _number,
            FrameStart = start + _faults.TimeOff,
            Exposure = _options.Exposure,
        };
    }

    private bool IsFrozen(TimeSpan start)
    {
        for (int i = 0; i < _options.Freezes.Count; i++)
        {
            if (_options.Freezes[i].Contains(start))
                return true;
        }

        return false;
    }

    private bool TryGetCameraPose(TimeSpan time, out CameraPose cameraPose)
    {
        bool isKnown = _truth.TryGet(time, out TruePose pose);
        cameraPose = isKnown ? new CameraPose(pose, _options) : default;
        return isKnown;
    }

    private TimeSpan Part(int quarters) => TimeSpan.FromTicks(_options.Exposure.Ticks * quarters / 4);

    private TimeSpan StartTime(long number)
        => _opened + TimeSpan.FromTicks((long)((number + 1) * TimeSpan.TicksPerSecond / _options.FramesPerSecond));

    private TimeSpan DueTime(long number) => StartTime(number) + _options.Delay;

    // A frozen camera shows the last one again and again.
    private readonly struct ShownPicture(in CameraPose middle, in CameraPose early, in CameraPose late, long number)
    {
        public CameraPose Middle { get; } = middle;

        public CameraPose Early { get; } = early;

        public CameraPose Late { get; } = late;

        public long Number { get; } = number;
    }
}
