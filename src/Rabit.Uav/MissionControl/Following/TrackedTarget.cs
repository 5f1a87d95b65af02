using System;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A target that a vehicle follows which searches alone, by its own tracks.</summary>
internal sealed class TrackedTarget(TargetTrack track) : IFollowedTarget
{
    private readonly TargetClassName _class = track.Class;

    /// <summary>The track that shows it now.</summary>
    public int TrackId { get; private set; } = track.Id;

    public TargetMotion Motion => track.Motion;

    public string Name => $"track {MissionNumbers.Of(TrackId)}";

    public TimeSpan InViewBefore => TimeSpan.Zero;

    // Meanwhile our lanes are not flown.
    public TimeSpan MaxSearch { get; } = TimeSpan.FromSeconds(15);

    public FollowMark Begin(MissionFlight flight) => FollowMark.Of(track, flight);

    public TargetTrack? Find(MissionFlight flight, PlanePoint expected, double radiusMetres)
    {
        TargetTrack? known = Revisits.Find(flight, TrackId);
        if (known is not (null or { State: TrackState.Lost }))
            return known;

        // The track ended with its target out of view, and another began when it was seen again.
        TargetTrack? again = flight.Tracks.Tracks
            .Where(t => t.State == TrackState.Confirmed && t.Class == _class && !flight.Revisits.IsFinished(t.Id))
            .Select(t => (Track: t, Distance: Revisits.PositionOf(t, flight).DistanceTo(expected)))
            .Where(t => t.Distance <= radiusMetres)
            .OrderBy(t => t.Distance).Select(t => t.Track).FirstOrDefault();
        if (again is null)
            return known;
        flight.Log($"track {MissionNumbers.Of(TrackId)} is followed as track {MissionNumbers.Of(again.Id)}");
        flight.Revisits.Continue(TrackId);
        TrackId = again.Id;
        return again;
    }

    public bool IsSeen(MissionFlight flight) => true;
}
