using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>
/// A simulated camera in virtual time over a vehicle that flies north at an even speed, 40 m up, and a manager that
/// takes its pictures.
/// </summary>
internal sealed class CameraRun : IDisposable
{
    private static readonly TimeSpan Step = TimeSpan.FromMilliseconds(10);

    private readonly RabitReactor _reactor;
    private TimeSpan _truthUntil;

    /// <param name="options">The camera.</param>
    /// <param name="speed">North, metres per second.</param>
    /// <param name="panel">What lies on the ground.</param>
    /// <param name="isMetered">
    /// Whether reads are measured; one may then be made several times, and pictures be lost.
    /// </param>
    public CameraRun(
        SimulatedCameraOptions options, double speed = 0, SimulatedTarget? panel = null, bool isMetered = false)
    {
        Camera = new SimulatedCamera(options, Truth, panel is null ? [] : [panel], seed: 1);
        Speed = speed;
        Meter = new MeteredSource(Camera);
        _reactor = new RabitReactor(new ReactorOptions { Time = new VirtualTime(3), StopsOnSignals = false })
        {
            new Taker(this, isMetered)
        };
        _reactor.Start();
    }

    public SimulatedCamera Camera { get; }

    /// <summary>Of the last read, where reads are measured.</summary>
    public MeteredSource Meter { get; }

    public double Speed { get; }

    public TruthHistory Truth { get; } = new(4000);

    /// <summary>What came, and when.</summary>
    public List<(TimeSpan Time, CameraFrame Frame)> Taken { get; } = [];

    public bool KeepsPictures { get; set; }

    /// <summary>The pixels of the last picture that came.</summary>
    public byte[] LastPicture { get; private set; } = [];

    /// <summary>Goes on, with the truth known of all that time.</summary>
    public void Fly(double seconds)
    {
        var duration = TimeSpan.FromSeconds(seconds);
        for (TimeSpan end = _reactor.Now + duration; _truthUntil <= end; _truthUntil += Step)
        {
            TruePose pose = Scene.Pose(40);
            pose.Time = _truthUntil;
            pose.Position = pose.Position with { North = Speed * _truthUntil.TotalSeconds };
            Truth.Add(pose);
        }

        _reactor.RunFor(duration);
    }

    /// <summary>Goes on without a word about where the vehicle is.</summary>
    public void Wait(double seconds)
    {
        _reactor.RunFor(TimeSpan.FromSeconds(seconds));
        _truthUntil = _reactor.Now;
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
    }

    private sealed class Taker : RabitManager
    {
        private readonly CameraRun _run;
        private readonly BlockingReader<CameraFrame> _reader;

        public Taker(CameraRun run, bool isMetered)
            : base("taker")
        {
            _run = run;
            _reader = AttachReader("camera", isMetered ? run.Meter : (IReaderSource<CameraFrame>)run.Camera);
        }

        protected override void ExecuteUnitOfWork()
        {
            while (_reader.TryPop(out CameraFrame frame))
            {
                _run.Taken.Add((Now, frame));
                _run.LastPicture = frame.Pixels.Span.Slice(0, frame.Width * frame.Height * 3).ToArray();
                if (!_run.KeepsPictures)
                    frame.Dispose();
            }
        }
    }
}
