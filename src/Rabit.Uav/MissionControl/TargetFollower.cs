using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Follows a target that moves: flies to where it is expected, and keeps it in the middle of the picture until it was
/// in view for <see cref="RevisitPlan.FollowTime"/>. A gimbal is pointed at it meanwhile. A target that is lost is
/// searched for in a growing area; a track of its class that begins there goes on as the same target.
/// </summary>
internal sealed class TargetFollower
{
    // The vehicle flies and holds to within a few metres.
    private const double FenceReserveMetres = 5;

    // After that a target has turned or stopped as often as not, and the picture shows where it may be around here.
    private const double MaxExtrapolationSeconds = 3;

    // Its place in the picture is less certain with every second; the picture is wider than what to fly to.
    private const double MaxPointingSeconds = 5;

    // A position that is commanded is approached with a lag. Half the time between two commands and what a command
    // takes are made up for, and some of the time constant of a position controller: with all of it the vehicle leans
    // more at each turn of the target, and a camera that leans with it loses the target (measured: FastFollowTests).
    private const double LeadSeconds = 0.6;

    // With a gimbal that keeps it in view anyway: also the way in which the autopilot brakes before each position, so
    // that the vehicle gets over a target at speed.
    private const double GimbalLeadSeconds = 2.5;

    // Of a fixed camera: half of the shorter side of usual pictures.
    private const double MaxPitchDegrees = -70;

    // Nearer than this there is no point in another command.
    private const double NewGoalMetres = 1;

    // From here on the way to the target is over, and what does not show it shows that it is lost.
    private const double ArrivedMetres = 15;

    // A track that begins so near goes on as the same target, beside how far that may have gone.
    private const double SameTargetMetres = 40;

    // Fewer commands are larger steps, each of which leans the vehicle more.
    private static readonly TimeSpan CommandPeriod = TimeSpan.OfSeconds(0.4);
    private static readonly TimeSpan MaxReportAge = TimeSpan.FromSeconds(2);

    // So long it is looked for where it is expected.
    private static readonly TimeSpan SearchAfter = TimeSpan.FromSeconds(5);

    // From when the angles are computed until the gimbal is there: a tick, the command, the turn.
    private const double PointingSeconds = 0.3;

    private readonly TransitPath _transit = new();
    private readonly GimbalPointing _pointing;
    private readonly TargetTurn _turn = new();
    private readonly PictureTurn _heading;
    private readonly double _height;
    private readonly double _classSpeed;
    private readonly IFollowedTarget _target;
    private readonly TimeSpan _wayThere;
    private readonly TimeSpan _begun;
    private FollowMark _mark;
    private GrowingSearch? _search;
    private PlanePoint _goal;
    private TimeSpan _commanded;
    private TimeSpan _lastTick;
    private TimeSpan? _lastInView;

    /// <summary>Begins to follow.</summary>
    /// <param name="flight">The vehicle and its mission.</param>
    /// <param name="target">The target.</param>
    /// <param name="headingRadians">
    /// Of the vehicle, for as long as the picture is not turned along the way of the target.
    /// </param>
    public TargetFollower(MissionFlight flight, IFollowedTarget target, double headingRadians)
    {
        (_target, _mark) = (target, target.Begin(flight));
        _heading = new PictureTurn(headingRadians, flight.Options.LongerSideOfPicture);
        _heading.Update(_mark);
        _height = flight.Mission.Revisit.HeightMetres ?? flight.Mission.HeightMetres;
        _classSpeed = TargetSpeeds.Of(target.Motion);
        _lastTick = _begun = flight.ActiveTime;
        InView = target.InViewBefore;
        _pointing = new GimbalPointing(flight.Options.GimbalFrame, flight.Mission.CameraYaw.Radians);
        _goal = flight.Position;
        _transit.Begin(flight, _goal);
        PlanePoint first = GoalFor(flight);
        _wayThere = TimeSpan.OfSeconds(2 * first.DistanceTo(_goal) / Speed(flight));
        Command(flight, first);
    }

    /// <summary>Whether the camera can show what the vehicle flies over: by itself, or by a gimbal.</summary>
    public static bool CanSee(MissionFlight flight)
        => flight.Camera.IsThere || flight.Mission.CameraPitch.Degrees <= MaxPitchDegrees;

    /// <summary>How long the target was in view.</summary>
    public TimeSpan InView { get; private set; }

    /// <summary>Whether it is over since the operator has rejected the target.</summary>
    public bool IsRejected { get; private set; }

    /// <summary>What is done now.</summary>
    public FollowProgress Progress { get; private set; }

    /// <summary>Goes on for a tick.</summary>
    /// <returns>Whether it is over: followed for long enough, lost, or no target.</returns>
    public bool Tick(MissionFlight flight)
    {
        TimeSpan step = flight.ActiveTime - _lastTick;
        _lastTick = flight.ActiveTime;
        TargetTrack? track = _target.Find(flight, Expected(flight), SameTargetMetres + (_search is null ? 0
            : _search.RadiusMetres(Unseen(flight))));
        if (track is { State: TrackState.Confirmed or TrackState.Lost } && track.Time >= _mark.Time)
        {
            FollowMark before = _mark;
            _mark = FollowMark.Of(track, flight);
            _turn.Update(before, _mark);
            _heading.Update(_mark);
        }

        bool isInView = track is { State: TrackState.Confirmed } && flight.Now - track.LastSeen <= MaxReportAge
            && _target.IsSeen(flight);
        if (isInView)
        {
            InView += step;
            (_lastInView, _search) = (flight.ActiveTime, null);
        }

        Go(flight, isInView);
        Look(flight, step.ExactSeconds);
        IsRejected = track?.State == TrackState.Rejected;
        return InView >= flight.Mission.Revisit.FollowTime || IsRejected
            || flight.ActiveTime - (_lastInView ?? (_begun + _wayThere)) > _target.MaxSearch;
    }

    // It is still there, or on the way there what others see of it is good enough.
    private void Go(MissionFlight flight, bool isInView)
    {
        bool hasArrived = _lastInView is not null || _search is not null
            || flight.Position.DistanceTo(GoalFor(flight)) <= ArrivedMetres;
        bool isLost = !isInView && hasArrived && flight.Now - _mark.Time > SearchAfter;
        Progress = isInView ? FollowProgress.InView
            : isLost ? FollowProgress.Searching
            : _lastInView is null ? FollowProgress.OnTheWay
            : Progress;
        if (isLost)
            Search(flight);
        else if (flight.ActiveTime - _commanded >= CommandPeriod)
            Command(flight, GoalFor(flight));
        else
            Fly(flight);
    }

    // At where it is expected when the picture is taken. One that is lost is searched for as the mission looks.
    private void Look(MissionFlight flight, double seconds)
    {
        if (!flight.Camera.IsThere || _search is not null)
            return;
        TimeSpan then = flight.Now + TimeSpan.OfSeconds(PointingSeconds);
        PlanePoint target = _mark.PlaceAt(then, MaxPointingSeconds);
        NedVector velocity = flight.Vehicle.VelocityNed;
        double ahead = (then - (flight.Vehicle.PositionTime ?? flight.Now)).ExactSeconds;
        PlanePoint off = target - flight.Position - (ahead * new PlanePoint(velocity.North, velocity.East));
        double ground = flight.Plan!.GroundAboveHome(target);
        _pointing.Point(
            new NedVector(off.North, off.East, flight.HeightMetres - ground),
            Rotation.FromEuler(flight.Vehicle.Attitude), seconds);
        flight.Camera.Point(_pointing.PitchRadians, _pointing.YawRadians);
    }

    private void Search(MissionFlight flight)
    {
        if (_search is null)
        {
            _search = new GrowingSearch(
                Expected(flight), _mark.Velocity.HeadingRadians, flight.Mission.LaneSpacingMetres, _classSpeed);
            flight.Log($"{_target.Name} is lost: searched for within "
                + $"{MissionNumbers.Of(GrowingSearch.MaxRadiusMetres)} m, for "
                + MissionNumbers.Seconds(_target.MaxSearch));
        }

        PlanePoint offset = RevisitPass.PlaceToSee(flight, default, _heading.HeadingRadians);
        PlanePoint look = _search.Next(
            flight.Position - offset, Unseen(flight),
            place => flight.Plan!.InsideMetres(place + offset) >= FenceReserveMetres);
        Command(flight, RevisitPass.PlaceToSee(flight, look, _heading.HeadingRadians));
    }

    private TimeSpan Unseen(MissionFlight flight) => flight.Now - _mark.Time;

    // Where it is now, as far as that can be said.
    private PlanePoint Expected(MissionFlight flight) => _mark.PlaceAt(flight.Now, MaxExtrapolationSeconds);

    // Where the vehicle has to be soon for the target to be in the middle of the picture.
    private PlanePoint GoalFor(MissionFlight flight)
    {
        PlanePoint ahead = flight.Camera.IsThere
            ? _turn.PlaceAt(_mark, Math.Min(MaxExtrapolationSeconds, Unseen(flight).ExactSeconds) + GimbalLeadSeconds)
            : Expected(flight) + (LeadSeconds * _mark.Velocity);
        return RevisitPass.PlaceToSee(flight, ahead, _heading.HeadingRadians);
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
        => flight.SetGoalPosition(_transit.Next(flight), _height, _heading.HeadingRadians, Speed(flight));

    /// <summary>How fast it is flown, metres per second: the operator may change that of the mission.</summary>
    public static double Speed(MissionFlight flight) => Math.Max(
        flight.Mission.SpeedMetresPerSecond, flight.Mission.Revisit.FollowSpeedMetresPerSecond ?? 0);
}
