using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>Sensor Fusion in virtual time, with the test in the place of the camera and of other vehicles.</summary>
internal sealed class FusionRig : IDisposable
{
    public static readonly GeodeticPosition Origin = GeodeticPosition.FromRadians(0.8, 0.15, 488);

    private readonly RabitReactor _reactor;
    private readonly QueueSender<Envelope<TargetReport>> _reports;
    private readonly QueueSender<CameraObservation> _observations;
    private readonly QueueSender<TrackDecision> _decisions;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly Outgoing<TargetReport> _sentReports = new("reports", MessageNames.OutgoingTargetReports);
    private readonly Outgoing<TrackEstimate> _sentEstimates = new("estimates", MessageNames.OutgoingTrackEstimates);
    private readonly QueueSender<Envelope<TrackEstimate>>? _estimates;
    private long _number;

    public FusionRig(Action<SensorFusionOptions>? change = null)
    {
        var options = new SensorFusionOptions();
        change?.Invoke(options);
        Manager = new SensorFusionManager(options);
        _reactor = new RabitReactor(new ReactorOptions { Time = new VirtualTime(1), StopsOnSignals = false })
        {
            Manager, _sentReports
        };
        if (options.SharesTracks)
        {
            _reactor.Add(_sentEstimates);
            _estimates = _reactor.Workspace.Send<Envelope<TrackEstimate>>(MessageNames.TrackEstimates);
        }

        _reports = _reactor.Workspace.Send<Envelope<TargetReport>>(MessageNames.TargetReports);
        _observations = _reactor.Workspace.Send<CameraObservation>(MessageNames.CameraObservations);
        _decisions = _reactor.Workspace.Send<TrackDecision>(MessageNames.TrackDecisions);
        _tracks = _reactor.Workspace.Subscribe<TrackList>(MessageNames.Tracks);
        _reactor.Start();
    }

    public SensorFusionManager Manager { get; }

    public SensorFusionCounters Counters => Manager.Counters;

    public List<Envelope<TargetReport>> SentReports => _sentReports.Items;

    public List<Envelope<TrackEstimate>> SentEstimates => _sentEstimates.Items;

    public TimeSpan Now => _reactor.Now;

    public TrackList List
    {
        get
        {
            _tracks.Fetch();
            return _tracks.Value;
        }
    }

    public IReadOnlyList<TargetTrack> Tracks => List.Tracks;

    public TargetTrack Only => Tracks.Single();

    public int Posts
    {
        get
        {
            _tracks.Fetch();
            return _tracks.Stamp.Version;
        }
    }

    public static TargetReport Report(
        double north, double east, TargetClassName? targetClass = null, double sigma = 0.5, double common = 0.5)
            => new()
            {
                SourceSystemId = 1,
                Position = LocalNedFrame.IgnoringGeoid(Origin).ToGeodetic(new NedPosition(north, east, 0)),
                Covariance = new HorizontalCovariance(sigma * sigma, 0, sigma * sigma),
                SystematicCovariance = new HorizontalCovariance(common * common, 0, common * common),
                Class = targetClass ?? DefaultTargetClasses.Red,
                Score = 0.9,
                SizeMetres = 1,
            };

    /// <summary>What another vehicle knows of a person that walks north with 1 m/s.</summary>
    public static TrackEstimate Known(byte source, TimeSpan time, double north, HorizontalCovariance covariance)
        => new()
        {
            SourceSystemId = source,
            TrackId = 4,
            PictureNumber = 77,
            Time = time,
            Position = LocalNedFrame.IgnoringGeoid(Origin).ToGeodetic(new NedPosition(north, 0, 0)),
            VelocityNed = new NedVector(1, 0, 0),
            Covariance = covariance,
            VelocityCovariance = new HorizontalCovariance(0.01, 0, 0.01),
            Class = new TargetClassName("person"),
        };

    /// <summary>Where a track is, metres from the origin.</summary>
    public static NedPosition PlaceOf(TargetTrack track) => LocalNedFrame.IgnoringGeoid(Origin).ToNed(track.Position);

    /// <summary>Half a second goes by, and a picture of 48 by 36 m around a point is searched.</summary>
    public void Observe(double north, double east, params TargetReport[] reports)
        => Observe(north, east, 18, 24, reports);

    /// <summary>The same with a picture of another size, half of it in metres.</summary>
    public void Observe(double north, double east, double toNorth, double toEast, params TargetReport[] reports)
    {
        Run(0.5);
        _number++;
        TargetReport[] numbered = [.. reports];
        for (int i = 0; i < numbered.Length; i++)
            (numbered[i].PictureNumber, numbered[i].Index, numbered[i].Time) = (_number, i, Now);

        var frame = LocalNedFrame.IgnoringGeoid(Origin);
        GeodeticPosition At(double n, double e) => frame.ToGeodetic(new NedPosition(north + n, east + e, 0));
        _observations.Push(new CameraObservation
        {
            SourceSystemId = 1,
            Number = _number,
            Time = Now,
            Reports = [.. numbered],
            TopLeft = At(toNorth, -toEast),
            TopRight = At(toNorth, toEast),
            BottomRight = At(-toNorth, toEast),
            BottomLeft = At(-toNorth, -toEast),
        });
        Run(0);
    }

    /// <summary>An observation that is wrong in itself.</summary>
    public void Push(CameraObservation observation) => _observations.Push(observation);

    /// <summary>The operator's decision.</summary>
    public void Decide(int trackId, TargetDecision decision)
    {
        _decisions.Push(new TrackDecision { TrackId = trackId, Decision = decision });
        Run(0.1);
    }

    /// <summary>A report of another vehicle.</summary>
    public void Push(TargetReport report) => _reports.Push(new Envelope<TargetReport> { Content = report });

    /// <summary>A track of another vehicle.</summary>
    public void Push(TrackEstimate estimate) => _estimates!.Push(new Envelope<TrackEstimate> { Content = estimate });

    public void Run(double seconds) => _reactor.RunFor(TimeSpan.FromSeconds(seconds));

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
    }

    /// <summary>In the place of Communications.</summary>
    private sealed class Outgoing<T> : RabitManager
        where T : struct
    {
        private readonly QueueReceiver<Envelope<T>> _sent;

        public Outgoing(string what, string queue)
            : base("outgoing " + what)
                => _sent = Receive<Envelope<T>>(queue);

        public List<Envelope<T>> Items { get; } = [];

        protected override void ExecuteUnitOfWork()
        {
            while (_sent.TryPop(out Envelope<T> envelope))
                Items.Add(envelope);
        }
    }
}
