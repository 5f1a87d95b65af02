using System;
using System.Collections.Generic;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Which point of a scan is of which track: the most likely pairing of all at once, where a track may also have been
/// missed or not exist, and a point may also be clutter or a new target. Fixed room; for one thread.
/// </summary>
internal sealed class ScanAssociation
{
    // Two numbers that were read and agree say more than the place: a wrong one of 50 would be as likely as that.
    private const double SameMarkerBonus = 4;

    // Pairs that are this much less likely than clutter are none.
    private const double MissCost = 10;

    private readonly double _gate;
    private readonly double _confirmedBonus;
    private readonly Assignment _assignment = new();
    private readonly int[] _columnOfPoint;
    private readonly int[] _pointOfColumn;
    private readonly List<(int Track, int Column, double Cost)> _pairs;
    private int _columns;

    public ScanAssociation(TrackerSettings settings)
    {
        _gate = settings.Gate;
        _confirmedBonus = settings.ConfirmedBonus;
        _columnOfPoint = new int[settings.MaxPoints];
        _pointOfColumn = new int[settings.MaxPoints];
        _pairs = new(settings.MaxPoints);
        _assignment.Reserve(settings.MaxTracks, settings.MaxPoints);
    }

    /// <summary>The point of a track; -1 for none.</summary>
    public int PointOf(int track)
    {
        int column = _assignment.ColumnOf(track);
        return column >= 0 ? _pointOfColumn[column] : -1;
    }

    /// <summary>Pairs the tracks, which expect the scan already, with its points.</summary>
    /// <param name="tracks">The tracks.</param>
    /// <param name="points">The points.</param>
    /// <param name="detectionProbability">Of the scan.</param>
    /// <param name="otherDensity">By class, how many points are of no track, per square metre.</param>
    public void Pair(
        List<MovingTrack> tracks,
        ReadOnlySpan<ScanPoint> points,
        double detectionProbability,
        ReadOnlySpan<double> otherDensity)
    {
        _pairs.Clear();
        _columns = 0;
        for (int p = 0; p < points.Length; p++)
            _columnOfPoint[p] = -1;
        for (int t = 0; t < tracks.Count; t++)
        {
            if (tracks[t].TakesPoints)
                AddPairs(t, tracks[t], points, detectionProbability, otherDensity[tracks[t].Class]);
        }

        // Only points near a track take part: most are clutter far from all.
        _assignment.Begin(tracks.Count, _columns, MissCost);
        foreach ((int track, int column, double cost) in _pairs)
            _assignment.Allow(track, column, cost);
        _assignment.Solve();
    }

    private void AddPairs(
        int index, MovingTrack track, ReadOnlySpan<ScanPoint> points, double detectionProbability, double otherDensity)
    {
        ExpectedPlace expected = track.Widest;
        double northNorth = expected.Covariance.NorthNorth;
        double eastEast = expected.Covariance.EastEast;
        double missed = 1 - (track.Visible * (1 - track.MissProbability));
        double weight = detectionProbability * track.Visible / (otherDensity * missed);
        for (int p = 0; p < points.Length; p++)
        {
            ref readonly ScanPoint point = ref points[p];
            double dn = point.Measurement.North - expected.North;
            double de = point.Measurement.East - expected.East;
            if (dn * dn > _gate * (northNorth + point.Measurement.Covariance.NorthNorth)
                || de * de > _gate * (eastEast + point.Measurement.Covariance.EastEast)
                || !track.MayBe(point))
                continue;
            if (!(expected.Compare(point.Measurement).DistanceSquared <= _gate))
                continue;
            double cost = -Math.Log(weight * track.Likelihood(point.Measurement));
            if (track.IsConfirmed)
                cost -= _confirmedBonus;
            if (point.Marker >= 0 && point.Marker == track.Marker)
                cost -= SameMarkerBonus;
            _pairs.Add((index, ColumnOf(p), cost));
        }
    }

    private int ColumnOf(int point)
    {
        if (_columnOfPoint[point] < 0)
        {
            _pointOfColumn[_columns] = point;
            _columnOfPoint[point] = _columns++;
        }

        return _columnOfPoint[point];
    }
}
