using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the radio between the vehicles of a simulated group is like. Read once, when the group is made.
/// </summary>
/// <example>
/// A bad one, and two vehicles that do not receive the third for 20 s:
/// <code>
/// var radio = new SimulatedRadioOptions
/// {
///     Loss = 0.4,
///     DuplicateFraction = 0.05,
///     Partitions = [new RadioPartition(TimeSpan.FromSeconds(60), TimeSpan.FromSeconds(20), [2])],
/// };
/// </code>
/// </example>
public sealed class SimulatedRadioOptions
{
    /// <summary>The time that a frame is on its way at least; also the step in which a group is simulated.</summary>
    public static TimeSpan MinLatency { get; } = TimeSpan.FromMilliseconds(20);

    /// <summary>The distance over which half of the frames are lost, metres; above zero.</summary>
    /// <value>The default is 3000.</value>
    public double HalfLossMetres { get; set; } = 3000;

    /// <summary>
    /// How fast the loss grows with the distance, metres: at <see cref="HalfLossMetres"/> less this it is 27 %, plus
    /// this 73 % (a logistic curve); above zero.
    /// </summary>
    /// <value>The default is 200.</value>
    public double LossSlopeMetres { get; set; } = 200;

    /// <summary>The fraction of the frames that is lost at any distance, 0 to 1.</summary>
    /// <value>The default is 0.</value>
    public double Loss { get; set; }

    /// <summary>
    /// How often a burst begins in which all frames between two stations are lost, per second; 0 or more.
    /// </summary>
    /// <value>The default is 0.</value>
    public double BurstsPerSecond { get; set; }

    /// <summary>How long a burst lasts on average (Gilbert and Elliott's model).</summary>
    /// <value>Above zero. The default is 0.5 s.</value>
    public TimeSpan BurstDuration { get; set; } = TimeSpan.OfSeconds(0.5);

    /// <summary>How long a frame is on its way, without jitter and the time in which it is sent.</summary>
    /// <value><see cref="MinLatency"/> to 10 s. The default is 40 ms.</value>
    public TimeSpan Latency { get; set; } = TimeSpan.FromMilliseconds(40);

    /// <summary>The mean of the jitter on top (exponential): frames overtake each other.</summary>
    /// <value>0 to 10 s. The default is 20 ms.</value>
    public TimeSpan Jitter { get; set; } = TimeSpan.FromMilliseconds(20);

    /// <summary>The fraction of the frames that arrives twice, 0 to 1.</summary>
    /// <value>The default is 0.</value>
    public double DuplicateFraction { get; set; }

    /// <summary>What all stations together can send, bytes per second; above zero.</summary>
    /// <value>The default is 7200: 57.6 kbit/s.</value>
    public int BytesPerSecond { get; set; } = 7200;

    /// <summary>When some stations do not receive the others, in any order.</summary>
    /// <value>The default is never.</value>
    public IReadOnlyList<RadioPartition> Partitions { get; set; } = Array.Empty<RadioPartition>();

    internal SimulatedRadioOptions Copy() => (SimulatedRadioOptions)MemberwiseClone();

    /// <param name="stations">How many stations there are: vehicles, and then ground stations.</param>
    internal IEnumerable<string> FindFaults(int stations)
    {
        if (!(HalfLossMetres > 0))
            yield return FormattableString.Invariant(
                $"{nameof(HalfLossMetres)} is {HalfLossMetres}; it must be above zero");
        if (!(LossSlopeMetres > 0))
            yield return FormattableString.Invariant(
                $"{nameof(LossSlopeMetres)} is {LossSlopeMetres}; it must be above zero");
        if (!(Loss >= 0 && Loss <= 1))
            yield return FormattableString.Invariant($"{nameof(Loss)} is {Loss}; it must be 0 to 1");
        if (!(DuplicateFraction >= 0 && DuplicateFraction <= 1))
            yield return FormattableString.Invariant(
                $"{nameof(DuplicateFraction)} is {DuplicateFraction}; it must be 0 to 1");
        if (!(BurstsPerSecond >= 0))
            yield return FormattableString.Invariant(
                $"{nameof(BurstsPerSecond)} is {BurstsPerSecond}; it must not be negative");
        if (BurstDuration <= TimeSpan.Zero)
            yield return $"{nameof(BurstDuration)} is {BurstDuration}; it must be above zero";
        if (Latency < MinLatency || Latency > TimeSpan.FromSeconds(10))
            yield return $"{nameof(Latency)} is {Latency}; it must be {MinLatency} to 10 s";
        if (Jitter < TimeSpan.Zero || Jitter > TimeSpan.FromSeconds(10))
            yield return $"{nameof(Jitter)} is {Jitter}; it must be 0 to 10 s";
        if (BytesPerSecond <= 0)
            yield return $"{nameof(BytesPerSecond)} is {BytesPerSecond}; it must be above zero";
        if (Partitions is null)
            yield return $"{nameof(Partitions)} is null; it may be empty";
        foreach (string fault in (Partitions ?? []).SelectMany(p => FindFaults(p, stations)))
            yield return $"{nameof(Partitions)} has one {fault}";
    }

    private static IEnumerable<string> FindFaults(RadioPartition? partition, int stations)
    {
        if (partition?.Stations is null)
        {
            yield return "that is null, or has no stations";
            yield break;
        }

        if (partition.At < TimeSpan.Zero || partition.Duration <= TimeSpan.Zero)
            yield return $"at {partition.At} for {partition.Duration}; both must be positive, the first may be zero";
        foreach (int station in partition.Stations.Where(s => s < 0 || s >= stations))
            yield return $"with station {station}; vehicles and ground stations are numbered from 0 to {stations - 1}";
    }
}
