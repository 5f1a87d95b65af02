using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Which confirmed targets were revisited, and which are still to be. Each once.</summary>
internal sealed class Revisits
{
    private readonly HashSet<int> _known = [];
    private readonly HashSet<int> _finished = [];
    private ImmutableArray<int> _shownFinished;
    private RevisitBudget? _budget;
    private int _charged;

    /// <summary>How many targets were revisited.</summary>
    public int Completed { get; private set; }

    /// <summary>How many targets were to be revisited and were not seen again.</summary>
    public int Failed { get; private set; }

    /// <summary>How many targets were not revisited for want of way or time.</summary>
    public int LeftOut { get; private set; }

    /// <summary>Tracks that are not to be revisited any more. Made again only when there are others.</summary>
    public ImmutableArray<int> Finished
        => !_shownFinished.IsDefault && _shownFinished.Length == _finished.Count
            ? _shownFinished
            : _shownFinished = _finished.OrderBy(id => id).ToImmutableArray();

    /// <summary>Logs the targets that are newly confirmed.</summary>
    public void LogConfirmed(MissionFlight flight)
    {
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            if (track.State == TrackState.Confirmed && _known.Add(track.Id))
            {
                flight.Log($"track {MissionNumbers.Of(track.Id)} confirmed: {Name(track)} at "
                    + $"{MissionNumbers.Of(PositionOf(track, flight))}, "
                    + $"95 % within {MissionNumbers.Of(track.Covariance.HalfMajorAxis95Metres)} m");
            }
        }
    }

    /// <summary>The nearest target that is to be revisited; null when there is none.</summary>
    public TargetTrack? Next(MissionFlight flight)
    {
        if (!flight.Mission.Revisit.IsEnabled || flight.IsFixedWing)
            return null;
        PlanePoint here = flight.Position;
        while (flight.Tracks.Tracks
            .Where(t => t.State == TrackState.Confirmed && !_finished.Contains(t.Id))
            .Where(t => flight.Mission.IsTarget(t.Class))
            .OrderBy(t => PositionOf(t, flight).DistanceTo(here)).ThenBy(t => t.Id).FirstOrDefault() is { } track)
        {
            string? why = WhyNot(track, flight) ?? WhyNoWay(track, flight);
            if (why is null)
                return track;
            _finished.Add(track.Id);
            flight.Log($"track {MissionNumbers.Of(track.Id)} {why}: no revisit");
        }

        return null;
    }

    private static string? WhyNot(TargetTrack track, MissionFlight flight)
    {
        if (RevisitPass.Plan(flight, PositionOf(track, flight)) is null)
            return "cannot be seen from inside the fence";
        foreach (MissionProgressTarget earlier in flight.Options.Resume?.Targets ?? [])
        {
            if (earlier.IsRevisited && ProgressTargets.AreSame(earlier, track))
                return "was revisited on an earlier flight";
        }

        return null;
    }

    // From here over the target to the next lane, instead of straight to that. Charged once, when it is decided.
    private string? WhyNoWay(TargetTrack track, MissionFlight flight)
    {
        if (track.Id == _charged)
            return null;
        _budget ??= new RevisitBudget(flight.Mission, flight.Plan!.Lanes);
        PlanePoint target = PositionOf(track, flight);
        PlanePoint next = flight.Route?.Current?.Start ?? flight.Position;
        double detour = flight.Position.DistanceTo(target) + target.DistanceTo(next) - flight.Position.DistanceTo(next);
        if (!_budget.Allows(detour))
        {
            LeftOut++;
            return $"would take {MissionNumbers.Of(detour)} m more; of the {MissionNumbers.Of(_budget.LimitMetres)} m "
                + $"for revisits {MissionNumbers.Of(_budget.UsedMetres)} m are used";
        }

        _charged = track.Id;
        _budget.TakeWay(detour);
        return null;
    }

    /// <summary>Ends the revisit of a target.</summary>
    /// <param name="id">Its track.</param>
    /// <param name="wasObserved">Whether the target was observed.</param>
    /// <param name="took">How long it took.</param>
    public void Finish(int id, bool wasObserved, TimeSpan took)
    {
        _budget?.TakeTime(took);
        if (!_finished.Add(id))
            return;
        if (wasObserved)
            Completed++;
        else
            Failed++;
    }

    public static TargetTrack? Find(MissionFlight flight, int id)
        => flight.Tracks.Tracks.FirstOrDefault(t => t.Id == id);

    public static PlanePoint PositionOf(TargetTrack track, MissionFlight flight)
    {
        NedPosition ned = flight.Plan!.Frame.ToNed(track.Position);
        return new PlanePoint(ned.North, ned.East);
    }

    public static string Name(TargetTrack track) => track.Class.ToString();
}
