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
    // A target that the vehicle passes later, or has passed, is left for then where that saves more than this: a lane
    // that is interrupted costs two stops and its overlap.
    private const double MinSavingMetres = 250;

    // What is nearer than this at another time is as near now.
    private const double SameMetres = 5;

    private readonly HashSet<int> _known = [];
    private readonly HashSet<int> _finished = [];
    private ImmutableArray<int> _shownFinished;
    private RevisitBudget? _budget;
    private int _charged;
    private int _chosen;

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
                    + $"{PlaceText(track, flight)}, "
                    + $"95 % within {MissionNumbers.Of(track.Covariance.HalfMajorAxis95Metres)} m");
            }
        }
    }

    // Of a group each vehicle has another home.
    private static string PlaceText(TargetTrack track, MissionFlight flight) => flight.Group is null
        ? MissionNumbers.Of(PositionOf(track, flight))
        : MissionNumbers.Of(track.Position);

    /// <summary>
    /// The nearest target that is to be revisited now; null when there is none. Between two lanes that is each that no
    /// later lane passes with much less way; on a lane, one beside it to which the way from its end is much longer.
    /// None while others of a group can validate it.
    /// </summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="isOnLane">Whether a lane is being flown.</param>
    public TargetTrack? Next(MissionFlight flight, bool isOnLane)
    {
        if (!flight.Mission.Revisit.IsEnabled || flight.IsFixedWing || flight.Group?.HasOthers(flight) == true)
            return null;
        PlanePoint here = flight.Position;
        while (NearestPending(flight, here, isOnLane) is { } track)
        {
            string? why = WhyNot(track, flight) ?? WhyNoWay(track, flight, isOnLane);
            if (why is null)
            {
                _chosen = track.Id;
                return track;
            }

            _finished.Add(track.Id);
            flight.Log($"track {MissionNumbers.Of(track.Id)} {why}: no revisit");
        }

        return null;
    }

    /// <summary>The target that <see cref="Next"/> gave last; null where there is no such track any more.</summary>
    public TargetTrack? Chosen(MissionFlight flight) => Find(flight, _chosen);

    private TargetTrack? NearestPending(MissionFlight flight, PlanePoint here, bool isOnLane)
    {
        TargetTrack? nearest = null;
        double least = double.PositiveInfinity;
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            if (track.State != TrackState.Confirmed || _finished.Contains(track.Id)
                || !flight.Mission.IsTarget(track.Class) || flight.Group?.IsValidated(flight, track) == true)
                continue;
            PlanePoint target = PositionOf(track, flight);
            double distance = target.DistanceTo(here);
            bool isNearer = distance < least || (distance.Equals(least) && track.Id < nearest!.Id);
            // One that moves is gone later. In a group it is followed by whom the group says.
            bool isNow = track.Motion != TargetMotion.Standing && flight.Mission.Revisit.FollowTime > TimeSpan.Zero;
            if (isNow && flight.Group is not null)
                continue;
            bool isTime = isNow || (isOnLane
                ? IsPassing(flight.Route!, here, target)
                : IsTimely(flight.Route!, here, target));
            if (isNearer && isTime)
                (nearest, least) = (track, distance);
        }

        return nearest;
    }

    // Between two lanes: whether no later lane saves much of the way.
    private static bool IsTimely(SearchRoute route, PlanePoint here, PlanePoint target)
        => Detour(here, target, route.Current?.Start ?? here)
            <= (2 * route.DistanceOfRest(target, withCurrent: true)) + MinSavingMetres;

    // On a lane: whether it is beside the lane, and no other time is as good.
    private static bool IsPassing(SearchRoute route, PlanePoint here, PlanePoint target)
    {
        double now = here.DistanceTo(target);
        PlanePoint end = route.Current!.Value.End;
        return Detour(end, target, route.Following?.Start ?? end) > (2 * now) + MinSavingMetres
            && now <= route.DistanceOfLeg(target) + SameMetres
            && now <= route.DistanceOfRest(target, withCurrent: false) + SameMetres;
    }

    private static double Detour(PlanePoint from, PlanePoint by, PlanePoint to)
        => from.DistanceTo(by) + by.DistanceTo(to) - from.DistanceTo(to);

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
    private string? WhyNoWay(TargetTrack track, MissionFlight flight, bool isOnLane)
    {
        if (track.Id == _charged)
            return null;
        RevisitBudget budget = BudgetOf(flight);
        PlanePoint here = flight.Position;
        PlanePoint next = isOnLane ? here : flight.Route?.Current?.Start ?? here;
        double detour = Detour(here, PositionOf(track, flight), next);
        if (budget.FindFault(detour) is { } fault)
        {
            LeftOut++;
            return fault;
        }

        _charged = track.Id;
        budget.TakeWay(detour);
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

    /// <summary>
    /// Why there is no way or time to follow a target for the group, as text; null where there is. Where all is seen
    /// nothing is kept from being searched: then only the energy limits it.
    /// </summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="place">Where it is.</param>
    public string? WhyNotFollowed(MissionFlight flight, PlanePoint place)
    {
        bool isSearched = flight.Route is { Current: null } && flight.SeenFraction >= flight.CoverageGoal;
        return isSearched ? null : BudgetOf(flight).FindFault(2 * flight.Position.DistanceTo(place));
    }

    /// <summary>Begins to follow a target for the group.</summary>
    public void BeginFollowing(MissionFlight flight, PlanePoint place)
        => BudgetOf(flight).TakeWay(2 * flight.Position.DistanceTo(place));

    /// <summary>Ends it.</summary>
    /// <param name="wasSeen">Whether the target was in view.</param>
    /// <param name="took">How long it took.</param>
    public void FinishFollowing(bool wasSeen, TimeSpan took)
    {
        _budget?.TakeTime(took);
        if (wasSeen)
            Completed++;
        else
            Failed++;
    }

    private RevisitBudget BudgetOf(MissionFlight flight)
        => _budget ??= new RevisitBudget(flight.Mission, flight.Plan!.Lanes);

    /// <summary>Whether a track is not to be revisited any more.</summary>
    public bool IsFinished(int id) => _finished.Contains(id);

    /// <summary>A track that ended while its target was followed, and goes on as another.</summary>
    public void Continue(int id) => _finished.Add(id);

    public static TargetTrack? Find(MissionFlight flight, int id)
        => flight.Tracks.Tracks.FirstOrDefault(t => t.Id == id);

    public static PlanePoint PositionOf(TargetTrack track, MissionFlight flight)
    {
        NedPosition ned = flight.Plan!.Frame.ToNed(track.Position);
        return new PlanePoint(ned.North, ned.East);
    }

    public static string Name(TargetTrack track) => track.Class.ToString();
}
