using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>What the phases of a mission share: the inputs, the plan and the progress.</summary>
internal sealed partial class MissionFlight(
    MissionPlan mission, MissionControlOptions options, CommandDispatcher commands, Action<string> log,
    OperatorActions operatorActions)
{
    // Below this a vehicle that reports no landed state is taken to be on the ground.
    private const double OnGroundHeightMetres = 2;

    // Twice the time in which pictures are processed.
    private const double OverlapSeconds = 3;

    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(1);

    // Heartbeats come once a second, and are missed rarely five times.
    private static readonly TimeSpan MaxReportAge = TimeSpan.FromSeconds(5);

    // Autopilots report several positions a second.
    private static readonly TimeSpan MaxPositionAge = TimeSpan.FromSeconds(2);

    private LocalNedFrame? _startFrame;
    private MissionChanges? _changes;
    private CameraDirector? _camera;
    private PlanePoint _wayFrom;
    private PlanePoint _wayTo;

    /// <summary>The mission as it is now: the operator may have changed it since the start.</summary>
    public MissionPlan Mission { get; private set; } = mission;

    public MissionControlOptions Options { get; } = options;

    public CommandDispatcher Commands { get; } = commands;

    /// <summary>Where the camera is pointed, beside what the vehicle does.</summary>
    public CameraDirector Camera => _camera ??= new CameraDirector(this);

    public Revisits Revisits { get; } = new();

    /// <summary>What is left in the battery, and what the way home takes.</summary>
    public EnergyModel Energy { get; } = new(options.Energy, mission);

    /// <summary>The group that the vehicle searches with; null where it searches alone.</summary>
    public MissionGroup? Group { get; } = options.Group is { } group ? new MissionGroup(group, log) : null;

    /// <summary>What the operator commanded.</summary>
    public OperatorRequests Operator { get; } = new(log);

    public OperatorActions OperatorActions { get; } = operatorActions;

    /// <summary>What the operator has changed of the mission and is not flown yet.</summary>
    public MissionChanges Changes => _changes ??= new MissionChanges(this);

    /// <summary>The command of the operator that led to the phase; null where none did.</summary>
    public OperatorRequest? Ordered { get; set; }

    /// <summary>Whether the operator gave the mission up before the take-off.</summary>
    public bool IsCalledOff { get; set; }

    /// <summary>The time of this tick.</summary>
    public TimeSpan Now { get; set; }

    /// <summary>
    /// Time in which the vehicle could be commanded: it stops while no autopilot is connected. Time-outs are in this
    /// time.
    /// </summary>
    public TimeSpan ActiveTime { get; set; }

    public VehicleState Vehicle { get; set; }

    /// <summary>When Autopilot Interface last posted anything of the vehicle.</summary>
    public TimeSpan VehicleReportTime { get; set; }

    public HealthReport Health { get; set; }

    /// <summary>How old the health report is.</summary>
    public TimeSpan HealthAge { get; set; }

    /// <summary>Whether the program is to stop.</summary>
    public bool IsStopRequested { get; set; }

    public CommandAuthority Authority { get; set; }

    /// <summary>When the operator gave the command of the vehicle to us last; null where that never was.</summary>
    public TimeSpan? ControlGivenTime { get; set; }

    public ImagingStatus Imaging { get; set; }

    /// <summary>Whether it holds until a reason of Health Monitoring ends.</summary>
    public bool IsHeldByHealth { get; set; }

    /// <summary>Whether a target is followed.</summary>
    public bool IsFollowing { get; set; }

    public PreflightReport Preflight { get; set; } = PreflightReport.None;

    public TrackList Tracks { get; set; } = TrackList.None;

    /// <summary>Null until the vehicle is ready.</summary>
    public FlightPlan? Plan { get; private set; }

    /// <summary>Null until the vehicle is ready.</summary>
    public SearchRoute? Route { get; private set; }

    /// <summary>Altitude of the ground, taken as level, metres above mean sea level.</summary>
    public double GroundAltitudeAmslMetres { get; private set; }

    /// <summary>Why the search was given up; null where it was not.</summary>
    public string? Aborted { get; set; }

    /// <summary>Who took the command away, and how; null where nothing did. A resume does not change it.</summary>
    public string? TakenOver { get; set; }

    /// <summary>Whether the command was taken away, and the mission not resumed.</summary>
    public bool IsTakenOver { get; set; }

    /// <summary>Whether the vehicle has landed or fallen.</summary>
    public TouchdownWatch Touchdown { get; } = new();

    /// <summary>Where the vehicle was last commanded to go.</summary>
    public PlanePoint GoalPosition { get; private set; }

    /// <summary>The height above home at which it is to be there.</summary>
    public double GoalHeightMetres { get; private set; }

    /// <summary>What is being done, as text.</summary>
    public string Text { get; set; } = string.Empty;

    /// <summary>
    /// Whether the vehicle can be commanded: heartbeats come, and Autopilot Interface reports them. Where it hangs, the
    /// last state says nothing of the vehicle, neither that it is connected nor that it has lost its position.
    /// </summary>
    public bool IsConnected => Vehicle.IsConnected && IsReported;

    /// <summary>Whether Autopilot Interface reports.</summary>
    public bool IsReported => Now - VehicleReportTime <= MaxReportAge;

    public bool HasFreshPosition => Vehicle.PositionTime is { } time && Now - time <= MaxPositionAge;

    /// <summary>
    /// Position of the vehicle in the local frame; without a plan relative to where it was first asked for.
    /// </summary>
    public PlanePoint Position
    {
        get
        {
            NedPosition ned = Frame.ToNed(Vehicle.Position);
            return new PlanePoint(ned.North, ned.East);
        }
    }

    /// <summary>
    /// Horizontal distance from home; NaN without a plan: the vehicle was flying already at the start.
    /// </summary>
    public double DistanceFromHomeMetres => Plan is null ? double.NaN : Position.Length;

    /// <summary>
    /// <see cref="DistanceFromHomeMetres"/> as text. Only the autopilot knows home where a vehicle that was flying
    /// already is only to hold or to return.
    /// </summary>
    public string DistanceText => Plan is null
        ? "home is the autopilot's, the distance from it not known here"
        : MissionNumbers.Of(DistanceFromHomeMetres) + " m from home";

    /// <summary>Whether the vehicle is a fixed wing: it is flown within limits.</summary>
    public bool IsFixedWing => FixedWings.IsFixedWing(Vehicle.VehicleType);

    /// <summary>Above home.</summary>
    public double HeightMetres => Vehicle.HeightAboveHomeMetres;

    /// <summary>
    /// Added to the height of each goal, metres: in a group, what the autopilot's altitude has drifted by since the
    /// take-off, so that the layers stay apart.
    /// </summary>
    public double HeightOffsetMetres { get; set; }

    /// <summary>Above ground where the mission follows terrain, else above home.</summary>
    public double HeightAboveGroundMetres
        => Plan?.Terrain is { } terrain && terrain.GroundMetres(Position) is var ground && !double.IsNaN(ground)
            ? HeightMetres - ground
            : HeightMetres;

    public double GroundSpeed => new PlanePoint(Vehicle.VelocityNed.North, Vehicle.VelocityNed.East).Length;

    public bool IsFlying => Vehicle.IsArmed && Vehicle.LandedState switch
    {
        MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing => true,
        MavLandedState.OnGround => false,
        _ => HeightMetres > OnGroundHeightMetres,
    };

    private LocalNedFrame Frame => Plan?.Frame ?? (_startFrame ??= LocalNedFrame.IgnoringGeoid(Vehicle.Position));

    /// <summary>Fraction of the area that must have been seen for the search to be complete.</summary>
    public double CoverageGoal => Math.Max(Options.CoverageGoal, RequiredCoverage);

    /// <summary>
    /// Fraction of the area that was seen: what we know of, or what another vehicle of the group reports where that is
    /// more. Vehicles send each other only the parts of lanes that were seen whole, so that each knows a little less
    /// than was seen.
    /// </summary>
    public double SeenFraction
        => Route is null ? 0 : Math.Max(Route.Coverage.Fraction, Group?.SeenFractionOfOthers ?? 0);

    /// <summary>
    /// Fraction of the area that must have been seen for the mission to be accomplished; 0 without a camera.
    /// </summary>
    public double RequiredCoverage => Options.RequiresCamera ? Mission.RequiredCoverage : 0;

    public void Log(string text) => log(text);

    /// <summary>Flies on with other values.</summary>
    public void ChangeMission(MissionPlan mission)
    {
        Mission = mission;
        Energy.Mission = mission;
    }

    /// <summary>Leaves out what remains of the leg to fly now.</summary>
    public void SkipLane()
    {
        if (Route?.Current is null)
            return;
        Log($"lane {MissionNumbers.Of(Route.Flown + 1)} of {MissionNumbers.Of(Route.Count)} left out");
        Route.SkipLeg();
    }

    /// <summary>Leaves the leg to fly now; what is missing of it may be flown over later.</summary>
    public void LeaveLane(string why)
    {
        if (Route?.Current is null)
            return;
        Log($"lane {MissionNumbers.Of(Route.Flown + 1)} of {MissionNumbers.Of(Route.Count)} is left: {why}");
        Route.FinishLeg();
    }

    /// <summary>
    /// How much of an interrupted lane is flown again: what the last pictures before showed may not have been seen.
    /// </summary>
    public double OverlapMetres => OverlapSeconds * Mission.SpeedMetresPerSecond;

    /// <summary>Measures the altitude of the ground with the vehicle that stands on it.</summary>
    public void MeasureGround() => GroundAltitudeAmslMetres = Vehicle.Position.AltitudeAmslMetres - HeightMetres;

    /// <summary>Whether the vehicle is at the height that is to be flown at a place.</summary>
    /// <param name="at">The place.</param>
    /// <param name="heightMetres">Above ground; above home where the ground is taken for level.</param>
    /// <param name="toleranceMetres">
    /// How much lower or higher it may be. Over terrain it may also be as much higher as the way to a goal needs.
    /// </param>
    public bool IsAtHeight(PlanePoint at, double heightMetres, double toleranceMetres)
    {
        double off = HeightMetres - Plan!.HeightAboveHome(at, heightMetres) - HeightOffsetMetres;
        double higher = Plan.Terrain is { } terrain
            ? terrain.MaxSlope * PathFollower.MaxGoalMetres(Mission.SpeedMetresPerSecond)
            : 0;
        return off >= -toleranceMetres && off <= toleranceMetres + higher;
    }

    /// <summary>Sets a position as the goal.</summary>
    /// <param name="to">The place.</param>
    /// <param name="heightMetres">
    /// Above ground, on the whole way there too; above home where the ground is taken for level.
    /// </param>
    /// <param name="yawRadians">The heading, clockwise from true north.</param>
    /// <param name="speed">Metres per second; null for that of the mission.</param>
    public void SetGoalPosition(PlanePoint to, double heightMetres, double yawRadians, double? speed = null)
    {
        if (Plan!.Terrain is not null)
            heightMetres = HeightOnTheWay(to, heightMetres);
        heightMetres += HeightOffsetMetres;
        GeodeticPosition position = Plan.Frame.ToGeodetic(new NedPosition(to.North, to.East, -heightMetres));
        var command = new VehicleCommand
        {
            Kind = VehicleCommandKind.GoTo,
            Latitude = position.Latitude,
            Longitude = position.Longitude,
            HeightAboveHomeMetres = heightMetres,
            SpeedMetresPerSecond = speed ?? Mission.SpeedMetresPerSecond,
            Yaw = Angle.FromRadians(yawRadians),
            LoiterRadiusMetres = IsFixedWing ? Options.FixedWing?.LoiterRadiusMetres ?? 0 : 0,
        };
        (GoalPosition, GoalHeightMetres) = (to, heightMetres);
        if (!Commands.IsGoal(command))
            Commands.SetGoal(
                command, $"go to {MissionNumbers.Of(to)}, height {MissionNumbers.Of(heightMetres)} m", RetryAfter);
    }

    // From where it was when it was first commanded there: the same in every tick.
    private double HeightOnTheWay(PlanePoint to, double heightMetres)
    {
        if (to.DistanceTo(_wayTo) > 0 || Commands.GoalKind != VehicleCommandKind.GoTo)
            (_wayFrom, _wayTo) = (Position, to);
        return Plan!.HeightAboveHome(_wayFrom, to, heightMetres);
    }

    /// <summary>The step to a landing where it is; a fixed wing returns instead, and is landed by its pilot.</summary>
    public MissionStep LandNow(string reason)
        => new(IsFixedWing ? MissionEvent.ReturnToLaunch : MissionEvent.LandNow, reason);

    /// <summary>Sets a goal that has no parameters.</summary>
    public void SetGoal(VehicleCommandKind kind, string text, TimeSpan? retryAfter = null)
        => Commands.SetGoal(new VehicleCommand { Kind = kind }, text, retryAfter ?? RetryAfter);
}
