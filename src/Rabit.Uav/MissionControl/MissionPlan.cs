using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// A mission: the area to search, how, and for what. Immutable. It is read from a mission file, whose form
/// docs/mission-file.md describes, or made in code.
/// </summary>
/// <example>
/// <code>
/// MissionPlan mission = MissionPlan.Parse(File.ReadAllText("field.json"), "field.json");
///
/// var sameInCode = new MissionPlan
/// {
///     Name = "field",
///     Area =
///     [
///         GeodeticPosition.FromDegrees(47.3982, 8.5445, 0), GeodeticPosition.FromDegrees(47.3982, 8.5467, 0),
///         GeodeticPosition.FromDegrees(47.3993, 8.5467, 0), GeodeticPosition.FromDegrees(47.3993, 8.5445, 0),
///     ],
///     HeightMetres = 40,
///     SpeedMetresPerSecond = 6,
///     LaneSpacingMetres = 30,
/// };
/// </code>
/// </example>
public sealed partial class MissionPlan
{
    internal const double DefaultRequiredCoverage = 0.98;

    private double _speed;

    /// <summary>Name of the mission.</summary>
    public string Name { get; init; } = "search";

    /// <summary>Corners of the area to search, in order, the first not repeated; altitudes are not used.</summary>
    public ImmutableArray<GeodeticPosition> Area { get; init; } = [];

    /// <summary>
    /// Polygons that the vehicle does not enter and that are not searched, each with its corners in order, the first
    /// not repeated; altitudes are not used.
    /// </summary>
    public ImmutableArray<ImmutableArray<GeodeticPosition>> KeepOuts { get; init; } = [];

    /// <summary>
    /// Height of the search above home, or above the terrain (<see cref="MissionControlOptions.Terrain"/>), metres, 5
    /// to 120.
    /// </summary>
    public double HeightMetres { get; init; }

    /// <summary>Ground speed, metres per second, 0.5 to 20.</summary>
    public double SpeedMetresPerSecond
    {
        get => _speed;
        init => _speed = value;
    }

    /// <summary>Maximum distance between lanes, metres, 2 to 200; below the width of a picture on the ground.</summary>
    public double LaneSpacingMetres { get; init; }

    /// <summary>
    /// Direction of the lanes, clockwise from true north; null for the one that needs the fewest lanes.
    /// </summary>
    public Angle? LaneHeading { get; init; }

    /// <summary>
    /// The classes of the targets of interest; empty, the default, for all that Image Processing has.
    /// </summary>
    public ImmutableArray<TargetClassName> Targets { get; init; } = [];

    /// <summary>
    /// How the targets of each class move; a class that is not there stands.
    /// </summary>
    public ImmutableDictionary<TargetClassName, TargetMotion> TargetMotions { get; init; }
        = ImmutableDictionary<TargetClassName, TargetMotion>.Empty;

    /// <summary>
    /// Classes of targets that this mission declares, beside those of Image Processing, or in place of one of the same
    /// name; empty by default.
    /// </summary>
    public ImmutableArray<TargetClass> TargetClasses { get; init; } = [];

    /// <summary>Where the vehicle is expected at the start; null where that is not checked.</summary>
    public MissionHome? Home { get; init; }

    /// <summary>
    /// Margin of the geofence around the area and the way to it from home, metres; around a convex area it is that
    /// around the convex hull of area and home.
    /// </summary>
    public double FenceMarginMetres { get; init; } = 40;

    /// <summary>How each confirmed target is revisited.</summary>
    public RevisitPlan Revisit { get; init; } = new();

    /// <summary>Camera pitch relative to the body, up positive; -90 degrees points straight down.</summary>
    public Angle CameraPitch { get; init; } = Angle.FromDegrees(-90);

    /// <summary>Camera yaw relative to the body, right positive.</summary>
    public Angle CameraYaw { get; init; }

    /// <summary>Whether a gimbal is to be pointed there; otherwise the camera is fixed in that direction.</summary>
    public bool HasGimbal { get; init; }

    /// <summary>
    /// Fraction of the area that the camera must have seen for the mission to be accomplished, 0 to 1. A mission that
    /// is flown without a camera has no such requirement.
    /// </summary>
    /// <value>
    /// The default is 0.98: rounding to cells and a roll of a few degrees at the border leave up to 2 %.
    /// </value>
    public double RequiredCoverage { get; init; } = DefaultRequiredCoverage;

    /// <summary>Fraction of the battery that must remain at the start, 0 to 1.</summary>
    public double MinBatteryFractionAtStart { get; init; } = 0.5;

    /// <summary>
    /// Fraction of the true charge of the battery that is to be left after the landing, 0.05 to 0.5: the vehicle
    /// returns when what is left is no more than the way home takes and this.
    /// </summary>
    public double EnergyReserveFraction { get; init; } = 0.1;

    /// <summary>
    /// Whether a mission that the battery cannot fly to its end is begun: the vehicle returns in time, and the rest can
    /// be flown later.
    /// </summary>
    public bool AllowsPartialSearch { get; init; }

    /// <summary>
    /// Whether it is begun with a battery whose charge the autopilot does not report: nothing says then whether it
    /// lasts, and in flight only its voltage is judged.
    /// </summary>
    public bool AllowUnknownBattery { get; init; }

    /// <summary>
    /// Limit of the height above home, or above the terrain (<see cref="MissionControlOptions.Terrain"/>), metres, 7 to
    /// 120; null for none of its own. Search and revisit stay 2 m below it; in flight, above it, the vehicle returns to
    /// launch. The autopilot's own return may climb higher.
    /// </summary>
    public double? MaxHeightMetres { get; init; }

    /// <summary>
    /// Limit of the horizontal distance from home, metres, 20 to 5000; null for none of its own. Lanes stay 10 m within
    /// it; in flight, beyond it, the vehicle returns to launch.
    /// </summary>
    public double? MaxDistanceMetres { get; init; }

    /// <summary>
    /// Height of the highest obstacle between the area and home, metres above home, 0 to 500; null where it is not
    /// known. The autopilot's return must be above it (docs/preflight.md).
    /// </summary>
    public double? ObstacleHeightMetres { get; init; }

    /// <summary>What the mission does where the ground station is lost.</summary>
    public GroundStationLoss GroundStationLost { get; init; } = new();

    /// <summary>Whether targets of a class are of interest.</summary>
    /// <param name="targetClass">The class of a track or a target.</param>
    public bool IsTarget(TargetClassName targetClass)
        => !targetClass.IsNone && (Targets.IsDefaultOrEmpty || Targets.Contains(targetClass));

    /// <summary>Reads a mission file and checks it.</summary>
    /// <param name="json">The text of the file.</param>
    /// <param name="name">Name of the mission in errors, and where the file gives none: the name of the file.</param>
    /// <param name="folder">
    /// Where files are that it names, as templates of target classes; null for the current folder.
    /// </param>
    /// <exception cref="MissionPlanException">
    /// The text is not a mission, or not one that can be flown; the message names all faults.
    /// </exception>
    public static MissionPlan Parse(string json, string name, string? folder = null)
    {
        if (json is null)
            throw new ArgumentNullException(nameof(json));
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("A mission needs a name for its error messages.", nameof(name));
        return MissionPlanReader.Read(json, name, folder ?? string.Empty);
    }
}
