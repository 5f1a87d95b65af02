using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Tracks of one class that were so near each other that their points may have been exchanged: which point is of which
/// is decided again with each later scan, as long as the points are kept. Fixed room; for one thread.
/// </summary>
internal sealed class Meetings
{
    /// <summary>More at a time are not looked at, and counted.</summary>
    public const int MaxPairs = 32;

    // Where a point of one would have been in the gate of the other.
    private const double NearSquared = 9.2;

    // Where both may be anywhere within this there is nothing to decide.
    private const double MaxNearMetres = 60;

    private readonly TrackerSettings _settings;
    private readonly MeetingResolver _resolver;
    private readonly MotionModel[] _models;
    private readonly Pair[] _pairs = new Pair[MaxPairs];
    private int _count;

    public Meetings(TrackerSettings settings, MotionModel[] models)
    {
        (_settings, _resolver) = (settings, new MeetingResolver(settings.KeptPoints, settings.ExchangeMargin));
        _models = models.Select(m => m.Steadier(settings.MeetingNoise)).ToArray();
    }

    /// <summary>Pairs that found no room.</summary>
    public long WithoutRoom { get; private set; }

    /// <summary>How often two tracks have exchanged their points.</summary>
    public long Exchanges { get; private set; }

    public void Clear() => _count = 0;

    /// <summary>After the points of a scan were taken in.</summary>
    /// <param name="tracks">All.</param>
    /// <param name="now">The time of the newest scan.</param>
    /// <param name="trackOfPoint">The numbers of the tracks of the points of the scan.</param>
    public void Update(List<MovingTrack> tracks, TimeSpan now, Span<int> trackOfPoint)
    {
        Note(tracks, now);
        for (int i = _count - 1; i >= 0; i--)
        {
            ref Pair pair = ref _pairs[i];
            MovingTrack? first = Find(tracks, pair.First);
            MovingTrack? second = Find(tracks, pair.Second);
            if (first is null || second is null || now - pair.Met > _settings.Window)
                pair = _pairs[--_count];
            else if (pair.IsNew(first.Filter, second.Filter)
                && _resolver.Resolve(first.Filter, second.Filter, _models[first.Class]))
                Exchange(first.Id, second.Id, trackOfPoint);
        }
    }

    private void Note(List<MovingTrack> tracks, TimeSpan now)
    {
        for (int i = 0; i < tracks.Count; i++)
        {
            if (!tracks[i].IsConfirmed)
                continue;
            for (int j = i + 1; j < tracks.Count; j++)
            {
                if (tracks[j].IsConfirmed && AreNear(tracks[i], tracks[j]))
                    Note(tracks[i].Id, tracks[j].Id, now);
            }
        }
    }

    private void Note(int first, int second, TimeSpan now)
    {
        for (int i = 0; i < _count; i++)
        {
            if (_pairs[i].First == first && _pairs[i].Second == second)
            {
                _pairs[i].Met = now;
                return;
            }
        }

        if (_count == MaxPairs)
            WithoutRoom++;
        else
            _pairs[_count++] = new Pair { First = first, Second = second, Met = now };
    }

    // Numbers that were read say more than the places.
    private static bool AreNear(MovingTrack a, MovingTrack b)
    {
        if (a.Class != b.Class || (a.Marker >= 0 && b.Marker >= 0) || a.IsTooNew || b.IsTooNew)
            return false;
        double north = a.Filter.Current.North - b.Filter.Current.North;
        double east = a.Filter.Current.East - b.Filter.Current.East;
        if (!(Math.Abs(north) <= MaxNearMetres && Math.Abs(east) <= MaxNearMetres))
            return false;
        HorizontalCovariance c = a.Filter.Current.PositionCovariance + b.Filter.Current.PositionCovariance
            + a.LastPointCovariance + b.LastPointCovariance;
        double determinant = (c.NorthNorth * c.EastEast) - (c.NorthEast * c.NorthEast);
        double distance = ((c.EastEast * north * north) - (2 * c.NorthEast * north * east)
            + (c.NorthNorth * east * east)) / determinant;
        return distance <= NearSquared;
    }

    private void Exchange(int first, int second, Span<int> trackOfPoint)
    {
        Exchanges++;
        foreach (ref int track in trackOfPoint)
            track = track == first ? second : track == second ? first : track;
    }

    private static MovingTrack? Find(List<MovingTrack> tracks, int id)
    {
        foreach (MovingTrack track in tracks)
        {
            if (track.Id == id)
                return track;
        }

        return null;
    }

    private struct Pair
    {
        public int First;
        public int Second;
        public TimeSpan Met;
        private int _versionOfFirst;
        private int _versionOfSecond;

        // What was decided with the same points is not decided again.
        public bool IsNew(OutOfSequenceFilter first, OutOfSequenceFilter second)
        {
            if (first.Version == _versionOfFirst && second.Version == _versionOfSecond)
                return false;
            (_versionOfFirst, _versionOfSecond) = (first.Version, second.Version);
            return true;
        }
    }
}
