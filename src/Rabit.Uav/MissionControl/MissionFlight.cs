using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Everything that the phases of a mission know and share: what came in, what is planned, how far it is.</summary>
internal sealed class MissionFlight(MissionPlan mission, MissionControlOptions options, CommandDispatcher desk, Action<string> log)
{
    // Below this a vehicle that does not tell whether it flies is taken to stand.
    private const double StandingHeightMetres = 2;

    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(1);

    // Autopilot Interface hears several positions a second.
    private static readonly TimeSpan PositionAge = TimeSpan.FromSeconds(2);

    public MissionPlan Mission { get; } = mission;

    public MissionControlOptions Options { get; } = options;

    public CommandDispatcher Desk { get; } = desk;

    public Revisits Looks { get; } = new();

    /// <summary>The time of this look at things.</summary>
    public TimeSpan Now { get; set; }

    /// <summary>Time in which something could be done: it stands still while the vehicle is not heard. Time limits are in this time.</summary>
    public TimeSpan ActiveTime { get; set; }

    public VehicleState Vehicle { get; set; }

    public HealthReport Health { get; set; }

    public CommandAuthority Authority { get; set; }

    public ImagingStatus Imaging { get; set; }

    public TrackList Tracks { get; set; } = TrackList.None;

    /// <summary>Null before the vehicle was ready.</summary>
    public FlightPlan? Plan { get; private set; }

    /// <summary>Null before the vehicle was ready.</summary>
    public SearchRoute? Route { get; private set; }

    /// <summary>Altitude of the ground, which is taken for flat, metres above mean sea level.</summary>
    public double GroundAltitudeAmslMetres { get; private set; }

    /// <summary>Why the search was given up; null where it was not.</summary>
    public string? Aborted { get; set; }

    /// <summary>What is being done, for people.</summary>
    public string Text { get; set; } = string.Empty;

    public bool IsHeard => Vehicle.IsConnected;

    public bool KnowsWhereItIs => Vehicle.PositionTime is { } time && Now - time <= PositionAge;

    /// <summary>Where the vehicle is; only with a plan.</summary>
    public PlanePoint Position
    {
        get
        {
            NedVector ned = Plan!.Frame.ToNed(Vehicle.Position);
            return new PlanePoint(ned.North, ned.East);
        }
    }

    public double HeightMetres => Vehicle.HeightAboveHomeMetres;

    public double GroundSpeed => new PlanePoint(Vehicle.VelocityNed.North, Vehicle.VelocityNed.East).Length;

    public bool IsFlying => Vehicle.IsArmed && Vehicle.LandedState switch
    {
        MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing => true,
        MavLandedState.OnGround => false,
        _ => HeightMetres > StandingHeightMetres,
    };

    public void Log(string text) => log(text);

    /// <summary>Lays the mission out from where the vehicle stands now.</summary>
    /// <returns>Why that cannot be; empty where it can.</returns>
    public string MakePlan()
    {
        GeodeticPosition at = Vehicle.Position;
        Plan = FlightPlan.Make(
            Mission, GeodeticPosition.FromRadians(at.LatitudeRadians, at.LongitudeRadians, at.AltitudeAmslMetres - HeightMetres), out string fault);
        if (Plan is not null)
            Route = new SearchRoute(Plan, Mission.LaneSpacingMetres);
        return fault;
    }

    /// <summary>Takes the altitude of the ground from the vehicle that stands on it.</summary>
    public void MeasureGround() => GroundAltitudeAmslMetres = Vehicle.Position.AltitudeAmslMetres - HeightMetres;

    /// <summary>Wants the vehicle to fly to a point.</summary>
    public void WantGoTo(PlanePoint to, double heightMetres, double yawRadians)
    {
        GeodeticPosition place = Plan!.Frame.ToGeodetic(new NedVector(to.North, to.East, -heightMetres));
        var command = new VehicleCommand
        {
            Kind = VehicleCommandKind.GoTo,
            LatitudeRadians = place.LatitudeRadians,
            LongitudeRadians = place.LongitudeRadians,
            HeightAboveHomeMetres = heightMetres,
            SpeedMetresPerSecond = Mission.SpeedMetresPerSecond,
            YawRadians = yawRadians,
        };
        if (!Desk.IsWanted(command))
            Desk.Want(command, $"go to {MissionText.Of(to)}, height {MissionText.Of(heightMetres)} m", RetryAfter);
    }

    /// <summary>Wants something that needs no figures.</summary>
    public void Want(VehicleCommandKind kind, string text, TimeSpan? retryAfter = null)
        => Desk.Want(new VehicleCommand { Kind = kind }, text, retryAfter ?? RetryAfter);
}
