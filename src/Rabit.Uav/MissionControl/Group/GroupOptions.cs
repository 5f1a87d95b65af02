using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How a vehicle searches an area together with others that fly the same mission: docs/managers/mission-control.md,
/// "Several vehicles".
/// </summary>
/// <example>
/// The second of three vehicles; each has a height of its own, so that they keep apart without a radio, too:
/// <code>
/// options.SystemId = 2;
/// options.MissionControl.Group = new GroupOptions { HeightLayer = 1 };
/// </code>
/// </example>
public sealed class GroupOptions
{
    /// <summary>The highest layer.</summary>
    public const int MaxLayer = 7;

    private const double MaxDetourMetres = 100_000;

    /// <summary>Vehicles at different heights are at least this far apart, metres.</summary>
    internal const double SeparationMetres = 15;

    /// <summary>
    /// So much nearer than their layers two vehicles come by the errors of their heights, metres: 3.5 in 200 flights.
    /// </summary>
    internal const double HeightErrorMetres = 4;

    /// <summary>The least distance of two layers, metres.</summary>
    public const double MinLayerSpacingMetres = SeparationMetres + HeightErrorMetres;

    /// <summary>
    /// How many layers above the height of the mission this vehicle flies. No two vehicles of a group have the same.
    /// </summary>
    /// <value>0 to <see cref="MaxLayer"/>. The default is 0.</value>
    public int HeightLayer { get; set; }

    /// <summary>From one layer to the next, metres; the same for all vehicles of a group.</summary>
    /// <value>
    /// <see cref="MinLayerSpacingMetres"/>, 19, to 100: 15 m of separation, and the errors of heights by satellite and
    /// barometer. The default is 20.
    /// </value>
    public double LayerSpacingMetres { get; set; } = 20;

    /// <summary>After what time without its report a vehicle counts as absent: its lanes are for others.</summary>
    /// <value>2 to 60 s. The default is 4.2 s: the fourth report that is missed, and some latency.</value>
    public TimeSpan SilentAfter { get; set; } = TimeSpan.OfSeconds(4.2);

    /// <summary>
    /// How long a vehicle that has flown its lanes waits for lanes of others at most, before it returns.
    /// </summary>
    /// <value>0 to 10 min. The default is 2 min.</value>
    public TimeSpan MaxWait { get; set; } = TimeSpan.FromMinutes(2);

    /// <summary>
    /// How much way a vehicle that has lanes to fly makes between two of them to validate a target of another one.
    /// Targets that are farther away are validated when the lanes are flown, or in passing.
    /// </summary>
    /// <value>0 to 100 000 m. The default is 150 m.</value>
    public double MaxValidationDetourMetres { get; set; } = 150;

    /// <summary>How much higher than the mission says this vehicle flies.</summary>
    internal double LayerMetres => HeightLayer * LayerSpacingMetres;

    /// <summary>How far above the height of the search the next layer is not touched.</summary>
    internal double SpareMetres => LayerSpacingMetres - SeparationMetres;

    internal GroupOptions Copy() => (GroupOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (HeightLayer is < 0 or > MaxLayer)
            yield return $"{nameof(HeightLayer)} is {HeightLayer}; it must be 0 to {MaxLayer}";
        if (!(LayerSpacingMetres >= MinLayerSpacingMetres && LayerSpacingMetres <= 100))
            yield return FormattableString.Invariant(
                $"{nameof(LayerSpacingMetres)} is {LayerSpacingMetres}; it must be {MinLayerSpacingMetres} to 100");
        if (SilentAfter < TimeSpan.FromSeconds(2) || SilentAfter > TimeSpan.FromMinutes(1))
            yield return $"{nameof(SilentAfter)} is {SilentAfter}; it must be 2 to 60 s";
        if (MaxWait < TimeSpan.Zero || MaxWait > TimeSpan.FromMinutes(10))
            yield return $"{nameof(MaxWait)} is {MaxWait}; it must be 0 to 10 min";
        if (!(MaxValidationDetourMetres >= 0 && MaxValidationDetourMetres <= MaxDetourMetres))
            yield return FormattableString.Invariant(
                $"{nameof(MaxValidationDetourMetres)} is {MaxValidationDetourMetres}; it must be 0 to ")
                + FormattableString.Invariant($"{MaxDetourMetres}");
    }
}
