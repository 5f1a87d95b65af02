using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The mission that Mission Control flies, its conditions and time-outs. Read once, when the manager is constructed.
/// </summary>
/// <example>
/// <code>
/// var options = new MissionControlOptions
/// {
///     Mission = MissionPlan.Parse(File.ReadAllText("field.json"), "field.json"),
///     ReadyTimeout = TimeSpan.FromMinutes(10),
///     CoverageGoal = 0.95,
/// };
/// var manager = new MissionControlManager(options);
/// </code>
/// </example>
public sealed class MissionControlOptions
{
    /// <summary>The mission; null to observe and command nothing.</summary>
    public MissionPlan? Mission { get; set; }

    /// <summary>
    /// Whether a mission waits for a camera before it begins, and is accomplished only when the camera has seen the
    /// area (<see cref="MissionPlan.RequiredCoverage"/>).
    /// </summary>
    /// <value>The default is true: a search without pictures finds nothing.</value>
    public bool RequiresCamera { get; set; } = true;

    /// <summary>
    /// Whether a mission waits until the pre-flight checklist passes; set where a system is composed that has one.
    /// </summary>
    /// <value>The default is false: without a system there is no checklist.</value>
    public bool RequiresPreflight { get; set; }

    /// <summary>
    /// What the angles of the mission's camera are against, where it is on a gimbal
    /// (<see cref="MissionPlan.HasGimbal"/>); in a system that of <c>Imaging.Mount</c>.
    /// </summary>
    /// <value>The default is <see cref="GimbalFrame.Body"/>.</value>
    public GimbalFrame GimbalFrame { get; set; }

    /// <summary>
    /// Time-out for the vehicle to be connected, healthy and to have a position; after it the mission has failed.
    /// </summary>
    /// <value>
    /// Above zero. The default is 5 min: a GNSS receiver needs a minute or two for its first fix after a cold start.
    /// </value>
    public TimeSpan ReadyTimeout { get; set; } = TimeSpan.FromMinutes(5);

    /// <summary>Time-out for arming; until then it is retried every 3 s.</summary>
    /// <value>
    /// Above zero. The default is 60 s: the pre-arm checks of a vehicle that has just started pass one after the other.
    /// </value>
    public TimeSpan ArmTimeout { get; set; } = TimeSpan.FromSeconds(60);

    /// <summary>
    /// Fraction of the area that the camera must have seen for the search to be complete, so that no gaps are flown
    /// over; <see cref="MissionPlan.RequiredCoverage"/> where that is more.
    /// </summary>
    /// <value>0 to 1. The default is 0.985: rounding to cells leaves up to a per cent along the border.</value>
    public double CoverageGoal { get; set; } = 0.985;

    /// <summary>How often, at most, gaps in the coverage are flown over after the lanes.</summary>
    /// <value>0 to 10. The default is 2: what two passes missed, a third misses too.</value>
    public int MaxGapPasses { get; set; } = 2;

    /// <summary>
    /// Whether the shortest way over an area that is not convex or has keep-outs is searched for before take-off. It
    /// takes seconds of one unit of work, and the way has more corners, at each of which a multirotor stops.
    /// </summary>
    /// <value>The default is false: a way that is some percent longer, in some tenths of a second.</value>
    public bool PlansShortestWay { get; set; }

    /// <summary>What is assumed of battery, power and wind before the flight has measured them.</summary>
    public EnergyOptions Energy { get; set; } = new();

    /// <summary>
    /// Whether a mission that the battery cannot fly to its end is begun, also where the mission does not say so
    /// (<see cref="MissionPlan.AllowsPartialSearch"/>).
    /// </summary>
    /// <value>The default is false.</value>
    public bool AllowsPartialSearch { get; set; }

    /// <summary>
    /// The ground: heights of the mission are kept above it instead of above home, and the limit of the height too. It
    /// must cover the fence and home.
    /// </summary>
    /// <value>The default is null: the ground is taken for level.</value>
    public TerrainGrid? Terrain { get; set; }

    /// <summary>
    /// Allows the mission to a fixed wing, within its limits: its pilot takes off and gives it over in the air, and
    /// lands it (docs/managers/mission-control.md, "Fixed wings"). In a <see cref="UavSystem"/> it also sets
    /// <see cref="AutopilotInterface.AutopilotOptions.MayCommandFixedWing"/>.
    /// </summary>
    /// <value>The default is null: a mission is refused to a fixed wing.</value>
    public FixedWingOptions? FixedWing { get; set; }

    /// <summary>
    /// How the vehicle searches together with others that fly the same mission; in a <see cref="UavSystem"/> it also
    /// has Communications exchange what they need for that.
    /// </summary>
    /// <value>The default is null: it searches alone.</value>
    public GroupOptions? Group { get; set; }

    /// <summary>What is commanded when the program is stopped while Mission Control flies the vehicle.</summary>
    /// <value>The default is <see cref="OnStop.Hold"/>.</value>
    public OnStop OnStop { get; set; }

    /// <summary>
    /// Progress of an earlier flight of the same mission, which is continued: what is flown and seen is not flown
    /// again. Home must be within 50 m of the one then.
    /// </summary>
    /// <value>The default is null: the mission begins at its beginning.</value>
    public MissionProgress? Resume { get; set; }

    /// <summary>
    /// Path of the file to which the progress of the mission is written, from its plan on: at each change of the phase,
    /// after each lane and every 5 s. A file that is there is replaced.
    /// </summary>
    /// <value>The default is null: it is not written.</value>
    public string? ProgressFile { get; set; }

    /// <summary>A mission as this vehicle flies it: in a group in the layer that is its own.</summary>
    internal MissionPlan? InLayer(MissionPlan? mission)
        => Group is { HeightLayer: > 0 } group ? mission?.HigherBy(group.LayerMetres) : mission;

    /// <summary>How far above the ground the autopilot must return; set where the system is composed.</summary>
    internal double ReturnClearanceMetres { get; set; } = 10;

    /// <summary>
    /// What else a mission that is changed in flight must be: what the system has checked of it at the start. Gives
    /// what is wrong; null where nothing is.
    /// </summary>
    internal Func<MissionPlan, string?>? FindsFaultOfChange { get; set; }

    /// <summary>
    /// How wide the strip is that the camera sees on a flight of a mission, metres; null where that is not known, or
    /// the camera does not look down. Set where the system is composed.
    /// </summary>
    internal Func<MissionPlan, double?>? SwathMetres { get; set; }

    /// <summary>
    /// From forward of the vehicle to the longer side of its pictures; null where there is none, or where the camera
    /// does not turn with the vehicle. Set where the system is composed.
    /// </summary>
    internal Angle? LongerSideOfPicture { get; set; }

    /// <exception cref="ArgumentException">
    /// Options are out of their range, or the mission cannot be flown; the text names all faults.
    /// </exception>
    internal MissionControlOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Mission Control: " + string.Join("; ", faults) + ".", parameter);
        MissionControlOptions copy = Copy();
        copy.Energy = Energy.Copy();
        copy.FixedWing = FixedWing?.Copy();
        copy.Group = Group?.Copy();
        return copy;
    }

    internal MissionControlOptions Copy() => (MissionControlOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (ReadyTimeout <= TimeSpan.Zero)
            yield return $"{nameof(ReadyTimeout)} is {ReadyTimeout}; it must be above zero";
        if (ArmTimeout <= TimeSpan.Zero)
            yield return $"{nameof(ArmTimeout)} is {ArmTimeout}; it must be above zero";
        if (!(CoverageGoal >= 0 && CoverageGoal <= 1))
            yield return FormattableString.Invariant($"{nameof(CoverageGoal)} is {CoverageGoal}; it must be 0 to 1");
        if (MaxGapPasses is < 0 or > 10)
            yield return FormattableString.Invariant($"{nameof(MaxGapPasses)} is {MaxGapPasses}; it must be 0 to 10");
        if (Energy is null)
            yield return $"{nameof(Energy)} is null; it may be left as it is";
        foreach (string fault in Energy?.FindFaults() ?? [])
            yield return $"{nameof(Energy)}: {fault}";
        foreach (string fault in FixedWing?.FindFaults() ?? [])
            yield return $"{nameof(FixedWing)}: {fault}";
        if (FixedWing is not null && Terrain is not null)
            yield return $"{nameof(Terrain)} is given, which a fixed wing ({nameof(FixedWing)}) does not follow";
        foreach (string fault in Group?.FindFaults() ?? [])
            yield return $"{nameof(Group)}: {fault}";
        if (Group is not null && (FixedWing is not null || Terrain is not null || Resume is not null))
            yield return $"{nameof(Group)} does not go with {nameof(FixedWing)}, {nameof(Terrain)} or {nameof(Resume)}";
        if (Group is not null && Mission is null)
            yield return $"{nameof(Group)} is there without a {nameof(Mission)}";
        if (OnStop is not (OnStop.Hold or OnStop.Return))
            yield return $"{nameof(OnStop)} is {OnStop:D}, which is none of its values";
        if (ProgressFile is not null && string.IsNullOrWhiteSpace(ProgressFile))
            yield return $"{nameof(ProgressFile)} is empty";
        if (Resume is not null && Mission is null)
            yield return $"{nameof(Resume)} is there without a {nameof(Mission)}";
        foreach (string fault in FaultsOfMission())
            yield return nameof(Mission) + fault;
        foreach (string fault in Resume is null || Mission is not { Area.IsDefault: false }
            ? [] : MissionPlanRules.FindFaults(Resume.Changes.ApplyTo(Mission)).Take(1))
            yield return $"{nameof(Resume)} has changes of the mission that cannot be flown: {fault}";
        if (Resume is not null && Mission is { Area.IsDefault: false }
            && Resume.Fingerprint != MissionFingerprint.Of(Mission))
        {
            yield return Resume.MissionName == Mission.Name
                ? $"{nameof(Resume)} is the progress of mission '{Mission.Name}' with other values than now"
                : $"{nameof(Resume)} is the progress of mission '{Resume.MissionName}', not of '{Mission.Name}'";
        }
    }

    private IEnumerable<string> FaultsOfMission() => Mission is null ? []
        : Group is { HeightLayer: > 0 } group ? HeightLayers.FindFaults(Mission, group)
        : MissionPlanRules.FindFaults(Mission).Select(f => ": " + f);
}
