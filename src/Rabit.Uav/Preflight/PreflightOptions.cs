using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Preflight;

/// <summary>
/// What the pre-flight checklist asks for, beside the rules of docs/preflight.md. Read once, when the system is opened.
/// </summary>
/// <example>
/// <code>
/// var options = new UavOptions { Mission = mission, MayCommand = true };
/// options.Preflight.Overrides = ["disk", "FS_THR_ENABLE"];
/// </code>
/// </example>
public sealed class PreflightOptions
{
    /// <summary>Whether a mission is refused while a line of the checklist fails.</summary>
    /// <value>
    /// The default is true. Where it is false nothing is read or checked: for an autopilot that keeps no parameters.
    /// </value>
    public bool IsRequired { get; set; } = true;

    /// <summary>Names of lines that may fail; a name that no line has is an error.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<string> Overrides { get; set; } = [];

    /// <summary>
    /// Height of the highest obstacle on the way home, metres above home; null for that of the mission, where it has
    /// one.
    /// </summary>
    public double? ObstacleHeightMetres { get; set; }

    /// <summary>
    /// The highest that the autopilot may return, metres above home: in a group a higher return is in the layer of
    /// another vehicle. Set where the system is composed; null for no limit.
    /// </summary>
    internal double? MaxReturnHeightMetres { get; set; }

    /// <summary>How far above the highest obstacle the vehicle must return.</summary>
    /// <value>
    /// 0 or more. The default is 10 m: barometric height drifts by some metres in a flight, and trees are measured
    /// roughly.
    /// </value>
    public double MinObstacleClearanceMetres { get; set; } = 10;

    /// <summary>Above this horizontal dilution of precision there is a warning.</summary>
    /// <value>Above 0. The default is 1.4, above which ArduPilot does not arm (GPS_HDOP_GOOD 140).</value>
    public double MaxHorizontalDilution { get; set; } = 1.4;

    /// <summary>
    /// Free bytes of the disk of <see cref="HealthMonitoring.HealthOptions.DataDirectory"/> below which its line fails.
    /// </summary>
    /// <value>The default is 100 MB: the log, the report and its pictures of a long flight are some 20 MB.</value>
    public long MinFreeDiskBytes { get; set; } = 100_000_000;

    /// <summary>
    /// Returns the time of this computer's clock, which names files and stamps logs, in UTC. Called by Health
    /// Monitoring's thread.
    /// </summary>
    /// <value>The default is null: the line is unknown.</value>
    public Func<DateTimeOffset>? UtcNow { get; set; }

    /// <summary>How old the last picture of the camera may be.</summary>
    /// <value>Above zero. The default is 5 s: cameras of searches take a picture every second or two.</value>
    public TimeSpan MaxPictureAge { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>What the mission asks for; set where the system is composed.</summary>
    internal double MinBatteryFraction { get; set; }

    /// <summary>Whether the charge of the battery may be unknown; set where the system is composed.</summary>
    internal bool AllowsUnknownBattery { get; set; }

    /// <summary>Whether the mission needs a camera; set where the system is composed.</summary>
    internal bool RequiresCamera { get; set; } = true;

    /// <summary>
    /// How large the smallest target is in the pictures; null without one. Set where the system is composed.
    /// </summary>
    internal SearchResolution? Resolution { get; set; }

    /// <summary>Whether other vehicles search too, in other layers; set where the system is composed.</summary>
    internal bool IsInGroup { get; set; }

    /// <summary>The ground; null where the mission takes it for level. Set where the system is composed.</summary>
    internal TerrainGrid? Terrain { get; set; }

    /// <summary>Corners of the area of the mission; set where the system is composed.</summary>
    internal IReadOnlyList<GeodeticPosition> SearchArea { get; set; } = [];

    /// <summary>How far outside it the mission may fly; set where the system is composed.</summary>
    internal double FenceMarginMetres { get; set; }

    internal PreflightOptions Copy()
    {
        var copy = (PreflightOptions)MemberwiseClone();
        copy.Overrides = Overrides.ToArray();
        return copy;
    }

    internal IEnumerable<string> FindFaults()
    {
        if (Overrides is null)
        {
            yield return $"{nameof(Overrides)} is null; it may be empty";
            yield break;
        }

        foreach (string name in Overrides.Where(n => !PreflightRules.Names.Contains(n, StringComparer.Ordinal)))
        {
            yield return $"{nameof(Overrides)} has '{name}', which no line of the pre-flight checklist has; there are "
                + string.Join(", ", PreflightRules.Names);
        }

        if (ObstacleHeightMetres is { } obstacle && !(obstacle >= 0 && obstacle <= 1000))
            yield return FormattableString.Invariant(
                $"{nameof(ObstacleHeightMetres)} is {obstacle}; it must be 0 to 1000");
        if (!(MinObstacleClearanceMetres >= 0 && MinObstacleClearanceMetres <= 1000))
            yield return FormattableString.Invariant(
                $"{nameof(MinObstacleClearanceMetres)} is {MinObstacleClearanceMetres}; it must be 0 to 1000");
        if (!(MaxHorizontalDilution > 0))
            yield return FormattableString.Invariant(
                $"{nameof(MaxHorizontalDilution)} is {MaxHorizontalDilution}; it must be above 0");
        if (MaxPictureAge <= TimeSpan.Zero)
            yield return $"{nameof(MaxPictureAge)} is {MaxPictureAge}; it must be above zero";
    }
}
