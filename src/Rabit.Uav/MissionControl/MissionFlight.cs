using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>What the phases of a mission share: the inputs, the plan and the progress.</summary>
internal sealed class MissionFlight(
    MissionPlan mission, MissionControlOptions options, CommandDispatcher commands, Action<string> log)
{
    // Below this a vehicle that reports no landed state is taken to be on the ground.
    private const double OnGroundHeightMetres = 2;

    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(1);

    // Autopilots report several positions a second.
    private static readonly TimeSpan MaxPositionAge = TimeSpan.FromSeconds(2);

    public MissionPlan Mission { get; } = mission;

    public MissionControlOptions Options { get; } = options;

    public CommandDispatcher Commands { get; } = commands;

    public Revisits Revisits { get; } = new();

    /// <summary>The time of this tick.</summary>
    public TimeSpan Now { get; set; }

    /// <summary>
    /// Time in which the vehicle could be commanded: it stops while no autopilot is connected. Time-outs are in this
    /// time.
    /// </summary>
    public TimeSpan ActiveTime { get; set; }

    public VehicleState Vehicle { get; set; }

    public HealthReport Health { get; set; }

    public CommandAuthority Authority { get; set; }

    public ImagingStatus Imaging { get; set; }

    public TrackList Tracks { get; set; } = TrackList.None;

    /// <summary>Null until the vehicle is ready.</summary>
    public FlightPlan? Plan { get; private set; }

    /// <summary>Null until the vehicle is ready.</summary>
    public SearchRoute? Route { get; private set; }

    /// <summary>Altitude of the ground, taken as level, metres above mean sea level.</summary>
    public double GroundAltitudeAmslMetres { get; private set; }

    /// <summary>Why the search was given up; null where it was not.</summary>
    public string? Aborted { get; set; }

    /// <summary>What is being done, as text.</summary>
    public string Text { get; set; } = string.Empty;

    public bool IsConnected => Vehicle.IsConnected;

    public bool HasFreshPosition => Vehicle.PositionTime is { } time && Now - time <= MaxPositionAge;

    /// <summary>Position of the vehicle in the local frame; only with a plan.</summary>
    public PlanePoint Position
    {
        get
        {
            NedPosition ned = Plan!.Frame.ToNed(Vehicle.Position);
            return new PlanePoint(ned.North, ned.East);
        }
    }

    public double HeightMetres => Vehicle.HeightAboveHomeMetres;

    public double GroundSpeed => new PlanePoint(Vehicle.VelocityNed.North, Vehicle.VelocityNed.East).Length;

    public bool IsFlying => Vehicle.IsArmed && Vehicle.LandedState switch
    {
        MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing => true,
        MavLandedState.OnGround => false,
        _ => HeightMetres > OnGroundHeightMetres,
    };

    public void Log(string text) => log(text);

    /// <summary>Plans the mission from the present position of the vehicle.</summary>
    /// <returns>Why that cannot be; empty where it can.</returns>
    public string CreatePlan()
    {
        GeodeticPosition at = Vehicle.Position;
        Plan = FlightPlan.Create(
            Mission,
            GeodeticPosition.FromRadians(
                at.Latitude.Radians, at.Longitude.Radians, at.AltitudeAmslMetres - HeightMetres),
            out string fault);
        if (Plan is not null)
            Route = new SearchRoute(Plan, Mission.LaneSpacingMetres);
        return fault;
    }

    /// <summary>Measures the altitude of the ground with the vehicle that stands on it.</summary>
    public void MeasureGround() => GroundAltitudeAmslMetres = Vehicle.Position.AltitudeAmslMetres - HeightMetres;

    /// <summary>Sets a position as the goal.</summary>
    public void SetGoalPosition(PlanePoint to, double heightMetres, double yawRadians)
    {
        GeodeticPosition position = Plan!.Frame.ToGeodetic(new NedPosition(to.North, to.East, -heightMetres));
        var command = new VehicleCommand
        {
            Kind = VehicleCommandKind.GoTo,
            Latitude = position.Latitude,
            Longitude = position.Longitude,
            HeightAboveHomeMetres = heightMetres,
            SpeedMetresPerSecond = Mission.SpeedMetresPerSecond,
            Yaw = Angle.FromRadians(yawRadians),
        };
        if (!Commands.IsGoal(command))
            Commands.SetGoal(
                command, $"go to {MissionNumbers.Of(to)}, height {MissionNumbers.Of(heightMetres)} m", RetryAfter);
    }

    /// <summary>Sets a goal that has no parameters.</summary>
    public void SetGoal(VehicleCommandKind kind, string text, TimeSpan? retryAfter = null)
        => Commands.SetGoal(new VehicleCommand { Kind = kind }, text, retryAfter ?? RetryAfter);
}
