using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Image Processing in virtual time, with the test in the place of all others.</summary>
internal sealed class ImagingRig : IDisposable
{
    /// <summary>Where the red panel of <see cref="Panel"/> lies, metres from the vehicle.</summary>
    public const double North = 6;
    public const double East = -4;

    private static readonly Lazy<byte[]> PanelPicture = new(() => Paint(hasPanel: true));
    private static readonly Lazy<byte[]> GrassPicture = new(() => Paint(hasPanel: false));

    private readonly QueueSender<PoseSample> _poses;
    private readonly MessagePublisher<ImagingCommand> _order;
    private readonly MessagePublisher<OwnAddress> _ownAddress;
    private readonly MessageSubscriber<ImagingStatus> _status;
    private readonly MessageSubscriber<LandingTargetObservation> _landingTarget;
    private bool _isFinished;

    public ImagingRig(ScriptedCamera? camera, ImageProcessingOptions? options = null, bool sinkIsSmall = false)
    {
        Camera = camera;
        options ??= new ImageProcessingOptions();
        options.Camera ??= View.Camera;
        options.Mount = View.Mount;
        Sink = new ObservationSink(sinkIsSmall ? 1 : 100);
        Manager = new ImageProcessingManager(options, camera);
        Reactor = new RabitReactor(new ReactorOptions { Time = new VirtualTime(1), Log = e => Log.Add(e.Text) })
        {
            Manager,
            Sink,
        };
        _poses = Reactor.Workspace.Send<PoseSample>(MessageNames.Poses);
        _order = Reactor.Workspace.Publish<ImagingCommand>(MessageNames.ImagingCommand);
        _ownAddress = Reactor.Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
        _status = Reactor.Workspace.Subscribe<ImagingStatus>(MessageNames.Imaging);
        _status.OnPost(_ => StatusTimes.Add(Reactor.Now));
        _landingTarget = Reactor.Workspace.Subscribe<LandingTargetObservation>(MessageNames.LandingTarget);
        Reactor.Start();
        _ownAddress.Value = new OwnAddress { SystemId = 7, ComponentId = 191 };
        _ownAddress.Post();
    }

    /// <summary>A picture of grass and a red panel, put there by the test's own projection.</summary>
    public static byte[] Panel => PanelPicture.Value;

    /// <summary>The same without the panel.</summary>
    public static byte[] Grass => GrassPicture.Value;

    public TestView View { get; } = new();

    public ScriptedCamera? Camera { get; }

    public ImageProcessingManager Manager { get; }

    public RabitReactor Reactor { get; }

    public ObservationSink Sink { get; }

    /// <summary>The texts of the log.</summary>
    public List<string> Log { get; } = [];

    public List<TimeSpan> StatusTimes { get; } = [];

    public ImagingStatus Status
    {
        get
        {
            // What is due now has been posted at the latest with the next status.
            Run(1);
            _status.Fetch();
            return _status.Value;
        }
    }

    /// <summary>The last one that was posted, with the time it is stamped with; null where there is none.</summary>
    public (TimeSpan Stamp, LandingTargetObservation Value)? LandingTarget
    {
        get
        {
            _landingTarget.Fetch();
            return _landingTarget.Stamp.Version == 0 ? null : (_landingTarget.Stamp.Time, _landingTarget.Value);
        }
    }

    /// <summary>A rig whose camera shows a picture, commanded to search.</summary>
    public static ImagingRig Search(byte[] picture, ImageProcessingOptions? options = null)
    {
        var rig = new ImagingRig(new ScriptedCamera(picture), options);
        rig.Order(ImagingMode.Search);
        return rig;
    }

    public void AssertAllGivenBack() => Assert.Equal($"{Camera!.Pool.Count} free", $"{Camera.Pool.Free} free");

    public void Order(ImagingMode mode, params TargetClassName[] classes)
    {
        _order.Value = View.Order with { Mode = mode, Classes = [.. classes] };
        _order.Post();
        Run(0);
    }

    /// <summary>Poses of a vehicle that hovers, from one time to another, ten a second.</summary>
    public void AddPoses(double from, double to)
    {
        for (int i = (int)Math.Round(from * 10); i <= (int)Math.Round(to * 10); i++)
        {
            _poses.Push(
                new PoseSample
                {
                    Kind = PoseSampleKind.Position,
                    Time = TimeSpan.FromSeconds(i / 10.0),
                    Position = View.Position
                });
            _poses.Push(
                new PoseSample
                {
                    Kind = PoseSampleKind.Attitude,
                    Time = TimeSpan.FromSeconds(i / 10.0),
                    Attitude = View.Attitude
                });
        }
    }

    /// <summary>What the gimbal reports.</summary>
    public void AddGimbal(double seconds, double pitchDegrees) => _poses.Push(new PoseSample
    {
        Kind = PoseSampleKind.Gimbal,
        Time = TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond)),
        Gimbal = GimbalAttitude.AgainstBody(Angle.FromDegrees(pitchDegrees), Angle.Zero),
    });

    /// <summary>One position and one attitude.</summary>
    public void AddPose(
        double seconds, GeodeticPosition position, NedVector velocity, EulerAngles attitude, BodyRates rates)
    {
        TimeSpan time = TimeSpan.FromSeconds(seconds);
        _poses.Push(
            new PoseSample
            {
                Kind = PoseSampleKind.Position,
                Time = time,
                Position = position,
                VelocityNed = velocity
            });
        _poses.Push(new PoseSample { Kind = PoseSampleKind.Attitude, Time = time, Attitude = attitude, Rates = rates });
    }

    public void Run(double seconds) => Reactor.RunFor(TimeSpan.FromSeconds(seconds));

    public ReactorResult Finish()
    {
        _isFinished = true;
        Reactor.Stop();
        return Reactor.Finish();
    }

    public void Dispose()
    {
        if (!_isFinished)
            Finish();
    }

    private static byte[] Paint(bool hasPanel)
    {
        var painting = new Painting(21);
        var view = new TestView();
        Assert.True(view.TryProject(North, East, out double column, out double row));
        Assert.True(view.TryProject(North + 1, East, out _, out double rowAMetreOn));
        if (hasPanel)
            painting.Panel(DefaultTargetClasses.Red, column, row, row - rowAMetreOn, 0.4);
        return painting.Finish();
    }
}
