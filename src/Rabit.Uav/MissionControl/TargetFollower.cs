using System;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Follows a target that moves: flies to where it is expected, and keeps it in the middle of the picture for
/// <see cref="RevisitPlan.FollowTime"/>. A target that is lost is looked for where it may have gone, as long as
/// <see cref="MaxLost"/>; a track of its class that begins there goes on as the same target.
/// </summary>
internal sealed class TargetFollower
{
    // The vehicle flies and holds to within a few metres.
    private const double FenceReserveMetres = 5;

    // After that a target has turned or stopped as often as not, and the picture shows where it may be around here.
    private const double MaxExtrapolationSeconds = 3;

    // A position that is commanded is approached with a lag: about the time constant of a position controller, half
    // the time between two commands and what a command takes.
    private const double LeadSeconds = 1.5;

    // Nearer than this there is no point in another command.
    private const double NewGoalMetres = 1;

    // How far a lost target may be when it is found again: it has gone on for MaxLost at walking speed, or turned.
    private const double SameTargetMetres = 60;

    private static readonly TimeSpan CommandPeriod = TimeSpan.FromSeconds(0.8);
    private static readonly TimeSpan MaxReportAge = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan MaxLost = TimeSpan.FromSeconds(15);

    private readonly TransitPath _transit = new();
    private readonly double _heading;
    private readonly double _height;
    private readonly TargetClassName _class;
    private readonly TimeSpan _wayThere;
    private PlanePoint _goal;
    private TimeSpan _commanded;
    private TimeSpan _lastTick;
    private TimeSpan _lastInView;
    private TimeSpan _inView;

    /// <summary>Begins to follow.</summary>
    /// <param name="flight">The vehicle and its mission.</param>
    /// <param name="track">The target.</param>
    /// <param name="headingRadians">Of the vehicle, all the time.</param>
    public TargetFollower(MissionFlight flight, TargetTrack track, double headingRadians)
    {
        (TrackId, _heading) = (track.Id, headingRadians);
        _height = flight.Mission.Revisit.HeightMetres ?? flight.Mission.HeightMetres;
        _class = track.Class;
        _lastTick = _lastInView = flight.ActiveTime;
        _goal = flight.Position;
        _transit.Begin(flight, _goal);
        PlanePoint first = GoalFor(flight, track);
        _wayThere = TimeSpan.FromSeconds(2 * first.DistanceTo(_goal) / Speed(flight));
        Command(flight, first);
    }

    /// <summary>The track that is followed now.</summary>
    public int TrackId { get; private set; }

    /// <summary>How long the target was in view.</summary>
    public TimeSpan InView => _inView;

    /// <summary>Goes on for a tick.</summary>
    /// <returns>Whether it is over: followed for long enough, or lost.</returns>
    public bool Tick(MissionFlight flight)
    {
        TimeSpan step = flight.ActiveTime - _lastTick;
        _lastTick = flight.ActiveTime;
        TargetTrack? track = Revisits.Find(flight, TrackId);
        if (track is null or { State: TrackState.Lost })
            track = FindAgain(flight) ?? track;
        bool isInView = track is { State: TrackState.Confirmed } && flight.Now - track.LastSeen <= MaxReportAge;
        if (isInView)
        {
            _inView += step;
            _lastInView = flight.ActiveTime;
        }

        if (track is not null && flight.ActiveTime - _commanded >= CommandPeriod)
            Command(flight, GoalFor(flight, track));
        else
            Fly(flight);
        TimeSpan limit = _inView > TimeSpan.Zero ? MaxLost : MaxLost + _wayThere;
        return _inView >= flight.Mission.Revisit.FollowTime || flight.ActiveTime - _lastInView > limit
            || track?.State == TrackState.Rejected;
    }

    // The track ended with its target out of view, and another began when it was seen again.
    private TargetTrack? FindAgain(MissionFlight flight)
    {
        TargetTrack? again = flight.Tracks.Tracks
            .Where(t => t.State == TrackState.Confirmed && t.Class == _class && !flight.Revisits.IsFinished(t.Id))
            .OrderBy(t => GoalFor(flight, t).DistanceTo(_goal))
            .FirstOrDefault(t => GoalFor(flight, t).DistanceTo(_goal) <= SameTargetMetres);
        if (again is null)
            return null;
        flight.Log($"track {MissionNumbers.Of(TrackId)} is followed as track {MissionNumbers.Of(again.Id)}");
        flight.Revisits.Continue(TrackId);
        TrackId = again.Id;
        return again;
    }

    // Where the vehicle has to be soon for the target to be in the middle of the picture.
    private PlanePoint GoalFor(MissionFlight flight, TargetTrack track)
    {
        double age = Math.Min(MaxExtrapolationSeconds, Math.Max(0, (flight.Now - track.Time).TotalSeconds));
        var velocity = new PlanePoint(track.VelocityNed.North, track.VelocityNed.East);
        PlanePoint target = Revisits.PositionOf(track, flight) + ((age + LeadSeconds) * velocity);
        return RevisitPass.PlaceToSee(flight, target, _heading);
    }

    private void Command(MissionFlight flight, PlanePoint goal)
    {
        // Beyond the fence it is not followed: the vehicle stays where it was sent last.
        if (goal.DistanceTo(_goal) >= NewGoalMetres && flight.Plan!.InsideMetres(goal) >= FenceReserveMetres)
        {
            _goal = goal;
            _commanded = flight.ActiveTime;
            _transit.Begin(flight, goal);
        }

        Fly(flight);
    }

    private void Fly(MissionFlight flight)
        => flight.SetGoalPosition(_transit.Next(flight), _height, _heading, Speed(flight));

    // In each tick: the operator may change that of the mission.
    private static double Speed(MissionFlight flight) => Math.Max(
        flight.Mission.SpeedMetresPerSecond, flight.Mission.Revisit.FollowSpeedMetresPerSecond ?? 0);
}
