using System;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A target that we follow for the group.</summary>
internal sealed class FollowedTask(FollowEntry entry, MissionGroup group) : IFollowedTarget
{
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(3);

    private int _track;

    /// <summary>The task.</summary>
    public FollowEntry Entry => entry;

    public TargetMotion Motion { get; } = group.MotionOf(entry.Task.Class);

    public string Name => _track == 0
        ? FollowBook.Name(entry.Task)
        : $"track {MissionNumbers.Of(_track)}, {FollowBook.Name(entry.Task)}";

    public TimeSpan InViewBefore { get; } = entry.Task.InView;

    public TimeSpan MaxSearch => GrowingSearch.MaxTime;

    public FollowMark Begin(MissionFlight flight) => FollowMark.Of(entry.Task, flight.Plan!.Frame);

    public TargetTrack? Find(MissionFlight flight, PlanePoint expected, double radiusMetres)
    {
        TargetTrack? known = _track == 0 ? null : Revisits.Find(flight, _track);
        if (known is { State: TrackState.Rejected }
            || (known is { State: TrackState.Confirmed } && flight.Now - known.LastSeen <= MaxAge))
            return known;
        TargetTrack? found = group.TracksOf(entry, flight)
            .Select(t => (Track: t, Distance: Revisits.PositionOf(t, flight).DistanceTo(expected)))
            .Where(t => t.Distance <= radiusMetres)
            .OrderBy(t => t.Distance).Select(t => t.Track).FirstOrDefault();
        if (found is null)
            return known;
        _track = found.Id;
        return found;
    }

    public bool IsSeen(MissionFlight flight) => group.SeesFollowed(flight);
}
