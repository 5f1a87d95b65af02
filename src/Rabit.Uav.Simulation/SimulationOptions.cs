using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Simulation;

/// <summary>What the simulated world is like. Read once, when it is made.</summary>
/// <example>
/// <code>
/// var options = new SimulationOptions
/// {
///     Seed = 7,
///     TargetCount = 8,
///     WindMetresPerSecond = 6,
///     WindFrom = Angle.FromDegrees(270),
///     Faults = [new ScriptedFault { Kind = ScriptedFaultKind.BatteryTo, At = TimeSpan.FromMinutes(2), Value = 0.2 }],
/// };
/// options.TakePlacesFrom(mission);   // home and area, so that the mission can be flown here
/// </code>
/// </example>
public sealed class SimulationOptions
{
    private const double MaxWind = 25;
    private const double MaxBarometerDrift = 20;

    /// <summary>
    /// All that is left to chance follows from it: targets, texture, gusts, errors of the sensors, times on the link.
    /// </summary>
    /// <value>The default is 1.</value>
    public long Seed { get; set; } = 1;

    /// <summary>Which autopilot the vehicle flies with.</summary>
    /// <value>The default is <see cref="SimulatedAutopilot.ArduPilot"/>.</value>
    public SimulatedAutopilot Autopilot { get; set; }

    /// <summary>
    /// The MAVLink system id of the vehicle, 1 to 254: the parameter SYSID_THISMAV or MAV_SYS_ID at the start.
    /// </summary>
    /// <value>The default is 1.</value>
    public byte SystemId { get; set; } = 1;

    /// <summary>
    /// Where the vehicle stands at the start: the origin of the world's frame. The ground is flat and at its
    /// altitude.
    /// </summary>
    /// <value>The default is the field near Canberra where ArduPilot's simulated copters start.</value>
    public GeodeticPosition Home { get; set; } = GeodeticPosition.FromDegrees(-35.363_262, 149.165_237, 584.09);

    /// <summary>The heading of the vehicle at the start, clockwise from north.</summary>
    /// <value>The default is 0.</value>
    public Angle Heading { get; set; }

    /// <summary>
    /// How long before the start of the run the autopilot was switched on, by its own clock; null: by the seed, 20 to
    /// 80 s.
    /// </summary>
    /// <value>The default is null.</value>
    public TimeSpan? BootedBefore { get; set; }

    /// <summary>
    /// How much too fast the autopilot's clock runs, parts per million; null: by the seed, about 20 either way.
    /// </summary>
    /// <value>The default is null.</value>
    public double? ClockDriftPpm { get; set; }

    /// <summary>
    /// How far the autopilot's altitude, by which the vehicle is steered, drifts from the true one, and from that of
    /// its satellite receiver: a barometer follows the weather and warms up. Standard deviation in the long run,
    /// metres, with ten minutes of correlation; it begins at zero. 0 to 20.
    /// </summary>
    /// <value>The default is 0: what the error of the position has on each axis is all.</value>
    public double BarometerDriftMetres { get; set; }

    /// <summary>After what time of the run the autopilot knows where it is.</summary>
    /// <value>The default is 5 s.</value>
    public TimeSpan PositionAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Mean wind, m/s, 0 to 25.</summary>
    /// <value>The default is 3.</value>
    public double WindMetresPerSecond { get; set; } = 3;

    /// <summary>Where the wind comes from, clockwise from north; null: by the seed.</summary>
    /// <value>The default is null.</value>
    public Angle? WindFrom { get; set; }

    /// <summary>What is left in the battery at the start, 0 to 1.</summary>
    /// <value>The default is 1.</value>
    public double BatteryRemaining { get; set; } = 1;

    /// <summary>
    /// True capacity of the battery over the stated one, 0.5 to 1: what remains of an aged battery. The autopilot
    /// counts its percentage from the stated capacity and does not know.
    /// </summary>
    /// <value>The default is 1.</value>
    public double BatteryCapacityFraction { get; set; } = 1;

    /// <summary>
    /// How long a frame of the vehicle is on its way at least; a jitter of some milliseconds comes on top. Zero: it
    /// arrives at once, without jitter, as between two processes of one computer.
    /// </summary>
    /// <value>The default is 20 ms.</value>
    public TimeSpan TelemetryLatency { get; set; } = TimeSpan.FromMilliseconds(20);

    /// <summary>How many targets lie in <see cref="Area"/>.</summary>
    /// <value>The default is 5.</value>
    public int TargetCount { get; set; } = 5;

    /// <summary>How many objects lie there that resemble targets and are not.</summary>
    /// <value>The default is 6.</value>
    public int DistractorCount { get; set; } = 6;

    /// <summary>
    /// What the targets are, in turn. They lie where coloured panels of the same seed would lie, beside the same
    /// distractors.
    /// </summary>
    /// <value>The default is none: all are <see cref="SimulatedTargetKind.ColouredPanel"/>.</value>
    public IReadOnlyList<SimulatedTargetKind> TargetKinds { get; set; } = Array.Empty<SimulatedTargetKind>();

    /// <summary>
    /// How many of the targets, the first that are no markers, are overgrown by a fifth to two fifths.
    /// </summary>
    /// <value>The default is 0.</value>
    public int PartlyHiddenCount { get; set; }

    /// <summary>Trees and roofs that hide what is below them from the camera.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<SimulatedOccluder> Occluders { get; set; } = Array.Empty<SimulatedOccluder>();

    /// <summary>
    /// How many more of them stand over the ways of the targets that move, in turn, by the seed; in a world in which
    /// none moves anywhere in <see cref="Area"/>. They hide no target that stands; what finds no place is left out.
    /// </summary>
    /// <value>The default is 0.</value>
    public int OccluderCount { get; set; }

    /// <summary>How the first targets move, in their order; those without one stand.</summary>
    /// <value>The default is none: all stand.</value>
    public IReadOnlyList<SimulatedMotion> Motions { get; set; } = Array.Empty<SimulatedMotion>();

    /// <summary>The camera under the vehicle.</summary>
    public SimulatedCameraOptions Camera { get; set; } = new();

    /// <summary>
    /// The corners of the area in which the targets lie, from home; down is not read.
    /// </summary>
    /// <value>The default is a rectangle of 120 by 160 m that begins 30 m north of home.</value>
    public IReadOnlyList<NedPosition> Area { get; set; } =
        [new NedPosition(30, -80, 0), new NedPosition(150, -80, 0), new NedPosition(150, 80, 0),
            new NedPosition(30, 80, 0)];

    /// <summary>
    /// Whether a ground station, 255/190, is connected to the vehicle by a second link of its own. It sends a
    /// heartbeat each second; see <see cref="ScriptedFaultKind.GroundStationSilent"/>.
    /// </summary>
    /// <value>The default is false.</value>
    public bool HasGroundStation { get; set; }

    /// <summary>
    /// Parameters of the autopilot that differ from its defaults at the start, by its own names, in its units.
    /// </summary>
    /// <value>The default is none.</value>
    public IReadOnlyDictionary<string, double> Parameters { get; set; }
        = new Dictionary<string, double>(StringComparer.Ordinal);

    /// <summary>
    /// Whether the failsafe parameters are those of a vehicle that was prepared for a flight, which pass the pre-flight
    /// checklist; otherwise they are the autopilot's defaults. <see cref="Parameters"/> count after it.
    /// </summary>
    /// <value>The default is true.</value>
    public bool IsPrepared { get; set; } = true;

    /// <summary>
    /// Whether ArduPilot's parameters have the names of its newer versions: MAV_SYSID for SYSID_THISMAV, MAV_GCS_SYSID
    /// for SYSID_MYGCS, and RTL_ALT_M, in metres, for RTL_ALT, in centimetres.
    /// </summary>
    /// <value>The default is false.</value>
    public bool HasNewerParameterNames { get; set; }

    /// <summary>What goes wrong, in any order.</summary>
    public IReadOnlyList<ScriptedFault> Faults { get; set; } = Array.Empty<ScriptedFault>();

    /// <summary>
    /// Takes home and the area in which the targets lie from a mission, and the direction of a camera that is fixed, so
    /// that it can be flown here. Where it names no home, that is its first corner.
    /// </summary>
    /// <param name="mission">The mission.</param>
    public void TakePlacesFrom(MissionPlan mission)
    {
        if (mission is null)
            throw new ArgumentNullException(nameof(mission));
        Home = mission.Home is { } home
            ? GeodeticPosition.FromRadians(
                home.Latitude.Radians, home.Longitude.Radians, home.GroundAltitudeAmslMetres ?? Home.AltitudeAmslMetres)
            : GeodeticPosition.FromRadians(
                mission.Area[0].Latitude.Radians, mission.Area[0].Longitude.Radians, Home.AltitudeAmslMetres);
        if (!mission.HasGimbal)
            (Camera.Pitch, Camera.Yaw) = (mission.CameraPitch, mission.CameraYaw);
        var frame = new WorldFrame(Home);
        Area = mission.Area
            .Select(c => GeodeticPosition.FromRadians(c.Latitude.Radians, c.Longitude.Radians, Home.AltitudeAmslMetres))
            .Select(c => NedPosition.Origin + frame.ToWorld(c)).ToArray();
    }

    internal SimulationOptions Copy() => (SimulationOptions)MemberwiseClone();

    /// <summary>Checks, and takes a copy that later changes do not reach.</summary>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal SimulationOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("The simulated world: " + string.Join("; ", faults) + ".", parameter);
        SimulationOptions copy = Copy();
        copy.Camera = (Camera
            ?? throw new ArgumentException(
                "The simulated world: the camera may be left as it is, but not null.", parameter))
            .ValidatedCopy(parameter);
        copy.Area = Area.ToArray();
        copy.Motions = Motions.ToArray();
        copy.Occluders = Occluders.ToArray();
        copy.TargetKinds = TargetKinds.ToArray();
        copy.Faults = Faults.OrderBy(f => f.At).Select(f => ScriptedFaultChecks.WithModeNumber(f, Autopilot)).ToArray();
        copy.Parameters = Parameters.ToDictionary(p => p.Key, p => p.Value, StringComparer.Ordinal);
        return copy;
    }

    private IEnumerable<string> FindFaults()
    {
        if (!(Math.Abs(Home.Latitude.Radians) < 89 * NedMath.RadiansPerDegree)
            || !(Math.Abs(Home.Longitude.Radians) <= Math.PI)
            || !(Math.Abs(Home.AltitudeAmslMetres) < 10_000))
        {
            yield return FormattableString.Invariant(
                $"{nameof(Home)} is {Home.Latitude.Radians}, {Home.Longitude.Radians} radians, {Home.AltitudeAmslMetres} m; it must be a place on earth, not at a pole");
        }

        if (Autopilot is not (SimulatedAutopilot.ArduPilot or SimulatedAutopilot.Px4))
            yield return FormattableString.Invariant(
                $"{nameof(Autopilot)} is {Autopilot}; there is none of that number");
        if (SystemId is 0 or byte.MaxValue)
            yield return $"{nameof(SystemId)} is {SystemId}; it must be 1 to 254: 255 is a ground station";
        if (!(Math.Abs(Heading.Radians) <= 2 * Math.PI))
            yield return FormattableString.Invariant(
                $"{nameof(Heading)} is {Heading}; it must be an angle of at most one turn");
        if (BootedBefore is { } booted && (booted < TimeSpan.Zero || booted > TimeSpan.FromDays(20)))
            yield return FormattableString.Invariant($"{nameof(BootedBefore)} is {booted}; it must be 0 to 20 days");
        if (ClockDriftPpm is { } drift && !(Math.Abs(drift) <= 1000))
            yield return FormattableString.Invariant($"{nameof(ClockDriftPpm)} is {drift}; it must be -1000 to 1000");
        if (PositionAfter < TimeSpan.Zero)
            yield return FormattableString.Invariant(
                $"{nameof(PositionAfter)} is {PositionAfter}; it must not be negative");
        if (!(BarometerDriftMetres >= 0 && BarometerDriftMetres <= MaxBarometerDrift))
        {
            yield return FormattableString.Invariant(
                $"{nameof(BarometerDriftMetres)} is {BarometerDriftMetres}; it must be 0 to {MaxBarometerDrift}");
        }

        if (!IsWind(WindMetresPerSecond))
            yield return FormattableString.Invariant(
                $"{nameof(WindMetresPerSecond)} is {WindMetresPerSecond}; it must be 0 to {MaxWind}");
        if (WindFrom is { } from && !(Math.Abs(from.Radians) <= 2 * Math.PI))
            yield return FormattableString.Invariant(
                $"{nameof(WindFrom)} is {from}; it must be an angle of at most one turn");
        if (!(BatteryRemaining >= 0 && BatteryRemaining <= 1))
            yield return FormattableString.Invariant(
                $"{nameof(BatteryRemaining)} is {BatteryRemaining}; it must be 0 to 1");
        if (!(BatteryCapacityFraction >= 0.5 && BatteryCapacityFraction <= 1))
            yield return FormattableString.Invariant(
                $"{nameof(BatteryCapacityFraction)} is {BatteryCapacityFraction}; it must be 0.5 to 1");
        if (TelemetryLatency < TimeSpan.Zero || TelemetryLatency > TimeSpan.FromSeconds(10))
            yield return FormattableString.Invariant(
                $"{nameof(TelemetryLatency)} is {TelemetryLatency}; it must be 0 to 10 s");
        if (TargetCount is < 0 or > 1000)
            yield return FormattableString.Invariant($"{nameof(TargetCount)} is {TargetCount}; it must be 0 to 1000");
        if (DistractorCount is < 0 or > 1000)
            yield return $"{nameof(DistractorCount)} is {DistractorCount}; it must be 0 to 1000";
        if (Motions is null || Motions.Count > TargetCount
            || Motions.Any(m => m is < SimulatedMotion.Standing or > SimulatedMotion.SteadyVehicle))
            yield return $"{nameof(Motions)} must be motions that there are, at most one for each of the "
                + $"{TargetCount} targets";
        if (TargetKinds is null
            || TargetKinds.Any(k => k is < SimulatedTargetKind.ColouredPanel or > SimulatedTargetKind.AprilTagMarker))
            yield return $"{nameof(TargetKinds)} must be kinds that there are";
        if (PartlyHiddenCount is < 0 or > 1000)
            yield return $"{nameof(PartlyHiddenCount)} is {PartlyHiddenCount}; it must be 0 to 1000";
        if (OccluderCount is < 0 or > 1000)
            yield return $"{nameof(OccluderCount)} is {OccluderCount}; it must be 0 to 1000";
        if (Occluders is null || Occluders.Any(o => o is null))
            yield return $"{nameof(Occluders)} may be empty, but neither null nor have such";
        for (int i = 0; i < (Occluders?.Count ?? 0); i++)
        {
            if (Occluders![i]?.FindFault() is { } fault)
                yield return FormattableString.Invariant($"{nameof(Occluders)}[{i}]: {fault}");
        }

        if (Area is null || Area.Count < 3)
            yield return $"{nameof(Area)} must have at least three corners";
        foreach (string fault in FindFaultsOfParameters().Concat(ScriptedFaultChecks.FindFaults(this)))
            yield return fault;
    }

    private IEnumerable<string> FindFaultsOfParameters()
    {
        if (Parameters is null)
        {
            yield return $"{nameof(Parameters)} is null; it may be empty";
            yield break;
        }

        Func<string, bool> isKnown = Autopilot == SimulatedAutopilot.Px4
            ? new Px4Parameters().Contains
            : new ParameterStore(HasNewerParameterNames).Contains;
        foreach (KeyValuePair<string, double> parameter in Parameters)
        {
            if (!isKnown(parameter.Key))
                yield return $"{nameof(Parameters)}: the simulated autopilot has no parameter '{parameter.Key}'";
            if (!(Math.Abs(parameter.Value) <= float.MaxValue))
                yield return FormattableString.Invariant(
                    $"{nameof(Parameters)}: {parameter.Key} is {parameter.Value}; it must be a finite number");
        }
    }

    internal static bool IsWind(double speed) => speed is >= 0 and <= MaxWind;
}
