using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Which track of ours is the target of which task of the group. A track of our own pictures that is none is announced;
/// of two tasks with one target one is kept. One thread.
/// </summary>
internal sealed class FollowLinks(FollowBook book)
{
    // Beside the uncertainties that both state, as far as these go.
    private const double SameMetres = 8;
    private const double MaxRadiusMetres = 10;
    private const double SameMetresPerSecond = 3;
    private const double MinSpeedAfterwards = 0.3;

    // A track so far from the target of its task is another target.
    private const double OtherMetres = 30;

    // What a message of the other vehicle can hold.
    private const double MaxSentRadiusMetres = 600;
    private const double MaxSpeed = 100;

    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(3);

    private const int MaxLinks = 512;

    // Later another target of the class may be where the one that was followed or rejected has gone: it is not
    // followed, but what it is is for the operator to say.
    private static readonly TimeSpan MaxRejectedAge = TimeSpan.FromSeconds(10);

    // Two targets that pass each other are not one.
    private static readonly TimeSpan SameTime = TimeSpan.FromSeconds(3);

    private readonly Dictionary<int, FollowEntry> _links = [];

    // Tracks that began where a target may have gone that was out of view for long, or beside one.
    private readonly HashSet<int> _perhapsOthers = [];
    private readonly Dictionary<TargetClassName, TargetMotion> _motions = [];

    /// <summary>All that were linked, in the order of the tracks.</summary>
    public ImmutableArray<FollowedTrack> Tracks => _links.OrderBy(l => l.Key)
        .Select(l => new FollowedTrack(l.Value.Task.Finder, l.Value.Task.Session, l.Value.Task.Number, l.Key))
        .ToImmutableArray();

    /// <summary>Whether a track is the target of a task that the operator has ended.</summary>
    public bool IsRejected(int trackId)
        => _links.TryGetValue(trackId, out FollowEntry? entry) && entry.Task.Result == FollowResult.Rejected;

    /// <summary>How targets of a class move; null before one was seen.</summary>
    public TargetMotion? MotionOf(TargetClassName name)
        => _motions.TryGetValue(name, out TargetMotion motion) ? motion : null;

    /// <summary>The tracks that show the target of a task.</summary>
    public IEnumerable<TargetTrack> TracksOf(FollowEntry entry, MissionFlight flight)
        => flight.Tracks.Tracks.Where(
            t => t.State == TrackState.Confirmed && _links.TryGetValue(t.Id, out FollowEntry? of) && of == entry);

    /// <summary>In each tick.</summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="own">Our system id.</param>
    /// <param name="mayAnnounce">Whether we fly the mission.</param>
    public void Update(MissionFlight flight, byte own, bool mayAnnounce)
    {
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            if (track.Motion == TargetMotion.Standing || !flight.Mission.IsTarget(track.Class))
                continue;
            if (track.Decision == TargetDecision.Rejected)
                EndRejected(flight, track, own);
            if (track.State != TrackState.Confirmed)
                continue;
            _motions[track.Class] = track.Motion;
            FollowEntry? entry = Link(flight, track);
            if (entry is null && mayAnnounce && IsOwn(track, flight))
                entry = book.Announce(TaskOf(track), own, flight.Now);
            if (entry is null)
                continue;
            AddLink(flight, track, entry);
            if (entry.Task.Result == FollowResult.Rejected && !_perhapsOthers.Contains(track.Id))
                flight.OperatorActions.RejectToo(flight, track);
            Refresh(entry, track);
        }

        if (book.IsPending)
            CloseSame(flight, own);
    }

    // A picture of our own; a track of another vehicle's reports alone is that vehicle's to announce.
    private static bool IsOwn(TargetTrack track, MissionFlight flight)
        => track.BestPictureNumber >= 0 && flight.Now - track.LastSeen <= MaxAge
            && !flight.Revisits.IsFinished(track.Id);

    private FollowEntry? Link(MissionFlight flight, TargetTrack track)
    {
        LocalNedFrame frame = flight.Plan!.Frame;
        PlanePoint place = FollowMark.Of(track, flight).PlaceAt(flight.Now, MaxAge.ExactSeconds);
        if (_links.TryGetValue(track.Id, out FollowEntry? known))
        {
            // What was followed, or rejected, stays so, as long as its track goes on.
            if (known.Task.Result is FollowResult.Followed or FollowResult.Rejected)
                return known;
            bool isOther = known.IsOver || (IsFresh(known, flight.Now) && flight.Now - track.LastSeen <= MaxAge
                && PlaceOf(known, frame, flight.Now).DistanceTo(place)
                    > OtherMetres + RadiusOf(track) + RadiusOf(known));
            if (!isOther)
                return known;
            _links.Remove(track.Id);
        }

        return Nearest(flight, track, place, FollowResult.None)
            ?? Nearest(flight, track, place, FollowResult.Followed)
            ?? Nearest(flight, track, place, FollowResult.Rejected);
    }

    // The operator has rejected it: it ends for all, also where another vehicle announces it afterwards.
    private void EndRejected(MissionFlight flight, TargetTrack track, byte own)
    {
        bool isSeen = flight.Now - track.LastSeen <= MaxRejectedAge;
        if (!_links.ContainsKey(track.Id) && isSeen && Link(flight, track) is { } found)
            AddLink(flight, track, found);
        if (_links.TryGetValue(track.Id, out FollowEntry? entry) && entry.Task.Result != FollowResult.Rejected
            && !_perhapsOthers.Contains(track.Id))
            entry.Close(own, FollowResult.Rejected, flight.Now);
    }

    // What is linked in time is the target, however late a reject of it reaches us. Where clutter makes track after
    // track the oldest links go.
    private void AddLink(MissionFlight flight, TargetTrack track, FollowEntry entry)
    {
        if (!_links.TryGetValue(track.Id, out FollowEntry? before) || before != entry)
        {
            bool isLate = flight.Now - entry.Task.Time > MaxRejectedAge;
            if (entry.IsOver && (isLate || IsShownByAnother(entry, track, flight)))
                _perhapsOthers.Add(track.Id);
            else
                _perhapsOthers.Remove(track.Id);
        }

        _links[track.Id] = entry;
        if (_links.Count <= MaxLinks)
            return;
        int oldest = _links.Keys.Min();
        _links.Remove(oldest);
        _perhapsOthers.Remove(oldest);
    }

    // The task of which the target may be there by now: one that is not over, or of a target that was followed or
    // rejected.
    private FollowEntry? Nearest(MissionFlight flight, TargetTrack track, PlanePoint place, FollowResult result)
    {
        bool isOver = result != FollowResult.None;
        FollowEntry? nearest = null;
        double least = double.PositiveInfinity;
        foreach (FollowEntry entry in book.Entries)
        {
            if (entry.Task.Result != result || !IsSuch(entry.Task, track.Class, track.MarkerId)
                || (!isOver && IsShownByAnother(entry, track, flight)))
                continue;
            double distance = PlaceOf(entry, flight.Plan!.Frame, flight.Now).DistanceTo(place);
            double seconds = Math.Max(0, (flight.Now - entry.Task.Time - MaxAge).ExactSeconds);
            double speed = isOver ? SpeedAfterwards(entry.Task) : TargetSpeeds.Of(track.Motion);
            double gone = Math.Min(GrowingSearch.MaxRadiusMetres, speed * seconds);
            if (distance <= SameMetres + RadiusOf(track) + RadiusOf(entry) + gone && distance < least)
                (nearest, least) = (entry, distance);
        }

        return nearest;
    }

    // Two tracks that are seen at the same time are two targets, however near.
    private bool IsShownByAnother(FollowEntry entry, TargetTrack track, MissionFlight flight)
        => flight.Now - track.LastSeen <= MaxAge
            && TracksOf(entry, flight).Any(t => t.Id != track.Id && flight.Now - t.LastSeen <= MaxAge);

    // It goes on about as fast as it went; one that stood may go on, too.
    private static double SpeedAfterwards(in FollowTask task)
        => Math.Max(MinSpeedAfterwards, 1.5 * new PlanePoint(task.VelocityNed.North, task.VelocityNed.East).Length);

    // The follower's own word is replaced by what it says next.
    private static void Refresh(FollowEntry entry, TargetTrack track)
    {
        if (entry.IsOver || track.Time <= entry.Task.Time)
            return;
        FollowTask seen = TaskOf(track);
        ref FollowTask task = ref entry.Task;
        (task.Position, task.VelocityNed, task.RadiusMetres, task.Time)
            = (seen.Position, seen.VelocityNed, seen.RadiusMetres, seen.Time);
    }

    // The task with the lower key is kept; the other is closed by the vehicle that repeats it.
    private void CloseSame(MissionFlight flight, byte own)
    {
        foreach (FollowEntry entry in book.Entries)
        {
            if (entry.IsOver)
                continue;
            FollowEntry? other = book.Entries.TakeWhile(e => e != entry)
                .FirstOrDefault(e => !e.IsOver && AreSame(e, entry, flight));
            entry.SameSince = other is null ? null : entry.SameSince ?? flight.Now;
            bool isNew = entry.Task.State == FollowState.Open && entry.Task.Follower == 0;
            if (other is null || !entry.IsSaidBy(own) || (!isNew && flight.Now - entry.SameSince < SameTime))
                continue;
            flight.Log($"{FollowBook.Name(entry.Task)} is {FollowBook.Name(other.Task)}");
            entry.Close(own, FollowResult.SameTarget, flight.Now);
        }
    }

    private bool AreSame(FollowEntry a, FollowEntry b, MissionFlight flight)
    {
        if (!IsSuch(a.Task, b.Task.Class, b.Task.MarkerId) || !IsFresh(a, flight.Now) || !IsFresh(b, flight.Now))
            return false;
        LocalNedFrame frame = flight.Plan!.Frame;
        NedVector apart = a.Task.VelocityNed - b.Task.VelocityNed;
        bool isThere = PlaceOf(a, frame, flight.Now).DistanceTo(PlaceOf(b, frame, flight.Now))
            <= SameMetres + RadiusOf(a) + RadiusOf(b)
            && new PlanePoint(apart.North, apart.East).Length <= SameMetresPerSecond;
        return isThere && !(Shows(a, flight) && Shows(b, flight));
    }

    // Where we see both as tracks of their own, they are two.
    private bool Shows(FollowEntry entry, MissionFlight flight)
        => TracksOf(entry, flight).Any(t => flight.Now - t.LastSeen <= MaxAge);

    private static bool IsFresh(FollowEntry entry, TimeSpan now) => now - entry.Task.Time <= MaxAge;

    private static PlanePoint PlaceOf(FollowEntry entry, LocalNedFrame frame, TimeSpan now)
        => FollowMark.Of(entry.Task, frame).PlaceAt(now, MaxAge.ExactSeconds);

    private static double RadiusOf(TargetTrack track)
        => Math.Min(MaxRadiusMetres, track.Covariance.HalfMajorAxis95Metres);

    private static double RadiusOf(FollowEntry entry) => Math.Min(MaxRadiusMetres, entry.Task.RadiusMetres);

    private static bool IsSuch(in FollowTask task, TargetClassName name, int? marker)
        => task.Class == name && task.MarkerId == marker;

    private static FollowTask TaskOf(TargetTrack track) => new()
    {
        Class = track.Class,
        MarkerId = track.MarkerId,
        Position = track.Position,
        VelocityNed = new NedVector(Limited(track.VelocityNed.North), Limited(track.VelocityNed.East), 0),
        RadiusMetres = Math.Min(MaxSentRadiusMetres, track.Covariance.HalfMajorAxis95Metres),
        Time = track.Time,
    };

    private static double Limited(double speed) => Math.Max(-MaxSpeed, Math.Min(MaxSpeed, speed));
}
