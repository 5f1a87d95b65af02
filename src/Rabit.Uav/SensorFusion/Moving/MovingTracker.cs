using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Tracks of targets that move: each scan is paired with all tracks at once; a track has a probability of existence,
/// which a point raises the more the less clutter there is, and a miss lowers (Musicki, Evans, Stankovic: "Integrated
/// Probabilistic Data Association", IEEE Trans. Automatic Control 39(6), 1994, here with the one most likely pairing).
/// A target that has been seen for a while may also be there and not be seen (their "Markov Chain Two"): its track is
/// occluded then, and goes on where it is seen again. Scans may arrive late, in any order; each only once. Fixed room:
/// a scan allocates nothing. For one thread.
/// </summary>
internal sealed partial class MovingTracker
{
    private const int LatePoint = -1;

    private readonly TrackerSettings _settings;
    private readonly MotionModel[] _models;
    private readonly ClutterEstimate[] _clutter;
    private readonly double[] _otherDensity;
    private readonly double[] _withoutTrack;
    private readonly List<MovingTrack> _tracks;
    private readonly Stack<MovingTrack> _unused;
    private readonly ScanAssociation _association;
    private readonly TrackStitcher _stitcher;

    // 0 for no track, or none any more; LatePoint for one that is too old.
    private readonly int[] _trackOfPoint;
    private readonly Func<int> _nextId;
    private TimeSpan? _time;

    /// <summary>Makes a tracker without tracks.</summary>
    /// <param name="settings">How it decides.</param>
    /// <param name="models">How the targets of each class move.</param>
    /// <param name="nextId">Gives the number of a new track.</param>
    public MovingTracker(TrackerSettings settings, MotionModel[] models, Func<int> nextId)
    {
        _settings = settings;
        _models = models;
        _nextId = nextId;
        _clutter = new ClutterEstimate[models.Length];
        _otherDensity = new double[models.Length];
        _withoutTrack = new double[models.Length];
        _tracks = new(settings.MaxTracks);
        _unused = new(settings.MaxTracks);
        for (int i = 0; i < settings.MaxTracks; i++)
            _unused.Push(new MovingTrack(settings));
        _association = new ScanAssociation(settings);
        _stitcher = new TrackStitcher(settings);
        Meetings = new Meetings(settings, models);
        _trackOfPoint = new int[settings.MaxPoints];
        Clear();
    }

    /// <summary>The tracks, confirmed and not.</summary>
    public IReadOnlyList<MovingTrack> Tracks => _tracks;

    /// <summary>The time of the newest scan.</summary>
    public TimeSpan Time => _time ?? TimeSpan.Zero;

    /// <summary>Points that updated a track.</summary>
    public long PointsUsed { get; private set; }

    /// <summary>Points that started a track.</summary>
    public long TracksStarted { get; private set; }

    /// <summary>Points older than the window, or than a state of another vehicle that a track goes on from.</summary>
    public long PointsLate { get; private set; }

    /// <summary>Points of a track that had them already.</summary>
    public long PointsTwice { get; private set; }

    /// <summary>Points that found no room: too many in their scan, or too many tracks.</summary>
    public long PointsWithoutRoom { get; private set; }

    /// <summary>Tracks that met.</summary>
    public Meetings Meetings { get; }

    /// <summary>Tracks that became occluded.</summary>
    public long TracksOccluded { get; private set; }

    /// <summary>Occluded tracks whose target was seen again.</summary>
    public long TracksFoundAgain { get; private set; }

    /// <summary>Tracks that went on as another one: each is also one that was found again.</summary>
    public long TracksJoined { get; private set; }

    /// <summary>
    /// Tracks that were deleted. Those that were started, by points or by states of others, less these and those that
    /// were joined, are the tracks that there are.
    /// </summary>
    public long TracksDeleted { get; private set; }

    /// <summary>The estimated clutter of a class, points per square metre and scan.</summary>
    public double ClutterDensity(int ofClass) => _clutter[ofClass].Density;

    /// <summary>Deletes all tracks and forgets the time and the clutter; the counts go on.</summary>
    public void Clear()
    {
        for (int t = _tracks.Count - 1; t >= 0; t--)
            Remove(t);
        Meetings.Clear();
        _clutter.AsSpan().Fill(new ClutterEstimate(_settings.MinClutterDensity));
        _time = null;
    }

    /// <summary>The track that a point of the last scan is in; null for none, or one that is gone already.</summary>
    public MovingTrack? TrackOfPoint(int point) => _trackOfPoint[point] > 0 ? Find(_trackOfPoint[point]) : null;

    /// <summary>Takes a scan in.</summary>
    /// <param name="scan">What is the same for all points.</param>
    /// <param name="points">Its points, valid, each seen for the first time.</param>
    public void Update(in Scan scan, ReadOnlySpan<ScanPoint> points)
    {
        Array.Clear(_trackOfPoint, 0, _trackOfPoint.Length);
        if (scan.Time < Time - _settings.Window)
        {
            PointsLate += points.Length;
            return;
        }

        if (points.Length > _settings.MaxPoints)
        {
            PointsWithoutRoom += points.Length - _settings.MaxPoints;
            points = points.Slice(0, _settings.MaxPoints);
        }

        Expect(scan, points.Length > 0 ? points[0].Measurement.Registration : default);
        _association.Pair(_tracks, points, scan.DetectionProbability, _otherDensity);
        UpdateTracks(scan, points);
        LeaveLate(points);
        Stitch(_trackOfPoint.AsSpan(0, points.Length));
        Meetings.Update(_tracks, Time, _trackOfPoint.AsSpan(0, points.Length));
        EstimateClutter(scan);
        StartTracks(points);
        Delete();
    }

    private void Expect(in Scan scan, HorizontalCovariance registration)
    {
        double seconds = _time is { } before ? Math.Max(0, (scan.Time - before).ExactSeconds) : 0;
        var step = new ExistenceStep(_settings, seconds);
        if (_time is null || scan.Time > _time)
            _time = scan.Time;
        foreach (MovingTrack track in _tracks)
            track.Expect(scan, registration, step);
        for (int i = 0; i < _models.Length; i++)
            _otherDensity[i] = _clutter[i].Density + _settings.BirthDensity;
    }

    private void UpdateTracks(in Scan scan, ReadOnlySpan<ScanPoint> points)
    {
        Array.Clear(_withoutTrack, 0, _withoutTrack.Length);
        foreach (ScanPoint point in points)
            _withoutTrack[point.Class]++;
        for (int t = 0; t < _tracks.Count; t++)
        {
            MovingTrack track = _tracks[t];
            int p = _association.PointOf(t);
            if (p < 0)
                Miss(track);
            else
                Take(track, points[p], p, scan.DetectionProbability);
        }
    }

    // Also one that was confirmed before it was clear that the other's target is not seen.
    private void Stitch(Span<int> trackOfPoint)
    {
        for (int t = _tracks.Count - 1; t >= 0; t--)
        {
            MovingTrack later = _tracks[t];
            if (!later.IsYoung || _stitcher.Find(_tracks, later) is not { } earlier)
                continue;
            earlier.GoOnAs(later);
            foreach (ref int track in trackOfPoint)
                track = track == later.Id ? earlier.Id : track;
            _unused.Push(later);
            _tracks.RemoveAt(t);
            TracksJoined++;
            TracksFoundAgain++;
        }
    }

    private void Miss(MovingTrack track)
    {
        bool wasOccluded = track.IsOccluded;
        track.Miss();
        TracksOccluded += track.IsOccluded && !wasOccluded ? 1 : 0;
    }

    private void Take(MovingTrack track, in ScanPoint point, int index, double detectionProbability)
    {
        double density = track.Likelihood(point.Measurement);
        double likelihood = track.MissProbability + (detectionProbability * density / _otherDensity[track.Class]);
        bool wasOccluded = track.IsOccluded;
        switch (track.Hit(point, likelihood))
        {
            case TakeResult.Used:
                PointsUsed++;
                TracksFoundAgain += wasOccluded && !track.IsOccluded ? 1 : 0;
                break;
            case TakeResult.Duplicate:
                PointsTwice++;
                break;
            default:
                PointsLate++;
                break;
        }

        _trackOfPoint[index] = track.Id;
        _withoutTrack[track.Class] -= track.Visible;
    }

    private void EstimateClutter(in Scan scan)
    {
        for (int i = 0; i < _models.Length; i++)
            _clutter[i].Add(_withoutTrack[i], scan.AreaSquareMetres);
    }

    private void StartTracks(ReadOnlySpan<ScanPoint> points)
    {
        for (int p = 0; p < points.Length; p++)
        {
            if (_trackOfPoint[p] != 0)
                continue;
            if (_unused.Count == 0)
            {
                PointsWithoutRoom++;
                continue;
            }

            int kind = points[p].Class;
            double existence = _settings.BirthDensity / (_settings.BirthDensity + _clutter[kind].Density);
            MovingTrack track = _unused.Pop();
            track.Start(_nextId(), points[p], _models[kind], existence);
            _tracks.Add(track);
            _trackOfPoint[p] = track.Id;
            TracksStarted++;
        }
    }

    private void Delete()
    {
        for (int t = _tracks.Count - 1; t >= 0; t--)
        {
            if (_tracks[t].IsOver(Time))
                Remove(t);
        }
    }

    private void Remove(int index)
    {
        _unused.Push(_tracks[index]);
        _tracks.RemoveAt(index);
        TracksDeleted++;
    }

    private MovingTrack? Find(int id)
    {
        foreach (MovingTrack track in _tracks)
        {
            if (track.Id == id)
                return track;
        }

        return null;
    }
}
