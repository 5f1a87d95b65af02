using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Which targets have been looked at again, and which are to be. Each once.</summary>
internal sealed class Revisits
{
    // Over a target the vehicle holds to within a few metres.
    private const double FenceReserveMetres = 5;

    private readonly HashSet<int> _known = [];
    private readonly HashSet<int> _finished = [];

    /// <summary>How many targets were looked at again.</summary>
    public int Done { get; private set; }

    /// <summary>Tells of targets that are newly believed.</summary>
    public void Note(MissionFlight flight)
    {
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            if (track.State == TrackState.Confirmed && _known.Add(track.Id))
            {
                flight.Log($"track {MissionText.Of(track.Id)} confirmed: {Name(track)} at {MissionText.Of(PlaceOf(track, flight))}, "
                    + $"95 % within {MissionText.Of(track.Covariance.HalfMajorAxis95Metres)} m");
            }
        }
    }

    /// <summary>The nearest target that is to be looked at; null when there is none.</summary>
    public TargetTrack? Next(MissionFlight flight)
    {
        if (!flight.Mission.Revisit.IsEnabled)
            return null;
        PlanePoint here = flight.Position;
        while (flight.Tracks.Tracks
            .Where(t => t.State == TrackState.Confirmed && (t.Colour & flight.Mission.Targets) != 0 && !_finished.Contains(t.Id))
            .OrderBy(t => PlaceOf(t, flight).DistanceTo(here)).ThenBy(t => t.Id).FirstOrDefault() is { } track)
        {
            if (flight.Plan!.Fence.SignedDistance(PlaceOf(track, flight)) >= FenceReserveMetres)
                return track;
            _finished.Add(track.Id);
            flight.Log($"track {MissionText.Of(track.Id)} stands at the fence or outside: no second look");
        }

        return null;
    }

    /// <summary>A target has had its turn.</summary>
    /// <param name="id">Its track.</param>
    /// <param name="wasSeen">Whether it was looked at.</param>
    public void Finish(int id, bool wasSeen)
    {
        if (_finished.Add(id) && wasSeen)
            Done++;
    }

    public static TargetTrack? Find(MissionFlight flight, int id) => flight.Tracks.Tracks.FirstOrDefault(t => t.Id == id);

    public static PlanePoint PlaceOf(TargetTrack track, MissionFlight flight)
    {
        NedVector ned = flight.Plan!.Frame.ToNed(track.Position);
        return new PlanePoint(ned.North, ned.East);
    }

    public static string Name(TargetTrack track) => track.Colour.ToString().ToLowerInvariant();
}
