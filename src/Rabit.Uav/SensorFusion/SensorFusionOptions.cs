using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>How Sensor Fusion makes tracks of reports. Read once, when the manager is made.</summary>
public sealed class SensorFusionOptions
{
    /// <summary>The largest squared Mahalanobis distance at which a report can belong to a track.</summary>
    /// <value>The default is 9.21: chi-square with two degrees of freedom, 99 %.</value>
    public double Gate { get; set; } = 9.21;

    /// <summary>
    /// In how many of the last <see cref="ConfirmOutOf"/> observations of its place a track must be reported to be
    /// confirmed.
    /// </summary>
    /// <value>The default is 3.</value>
    public int ConfirmHits { get; set; } = 3;

    /// <summary>See <see cref="ConfirmHits"/>; at most 16.</summary>
    /// <value>The default is 5.</value>
    public int ConfirmOutOf { get; set; } = 5;

    /// <summary>
    /// After how many misses in a row a confirmed track is lost. An observation that does not show its place is no
    /// miss.
    /// </summary>
    /// <value>The default is 6: three seconds with two pictures a second.</value>
    public int LostAfterMisses { get; set; } = 6;

    /// <summary>After what time without a report a track that was never confirmed is dropped.</summary>
    /// <value>The default is 2 min: longer than a neighbouring lane takes.</value>
    public TimeSpan TentativeLifetime { get; set; } = TimeSpan.FromMinutes(2);

    /// <summary>
    /// How far inside the border of a picture a track must be for a miss to count, metres, beside twice its own
    /// uncertainty.
    /// </summary>
    /// <value>The default is 1 m: a panel that the border cuts is not seen.</value>
    public double FootprintMarginMetres { get; set; } = 1;

    /// <summary>
    /// How long reports of another vehicle wait for the others of the same picture, which are then assigned together.
    /// </summary>
    /// <value>The default is 0.5 s.</value>
    public TimeSpan ReportGroupingDelay { get; set; } = TimeSpan.OfSeconds(0.5);

    /// <summary>How much older than the newest report of a track another one may be and still count.</summary>
    /// <value>The default is 10 s.</value>
    public TimeSpan LateWindow { get; set; } = TimeSpan.FromSeconds(10);

    /// <summary>
    /// How the targets of each class move; a class that is not there stands. <see cref="Gate"/> and
    /// what follows it are for those that stand.
    /// </summary>
    /// <value>The default is empty. What the mission says is added (<c>targetMotions</c> of its file).</value>
    public ImmutableDictionary<TargetClassName, TargetMotion> TargetMotions { get; set; }
        = ImmutableDictionary<TargetClassName, TargetMotion>.Empty;

    /// <summary>
    /// How far off the frame of a vehicle is, standard deviation per axis, metres, where its reports of a moving target
    /// do not state it (<see cref="TargetReport.SystematicCovariance"/>).
    /// </summary>
    /// <value>The default is 2 m.</value>
    public double RegistrationSigmaMetres { get; set; } = 2;

    /// <summary>
    /// How many tracks there may be, in any state. One more takes the place of the one that has not been reported for
    /// the longest, of those that were never confirmed, or are lost; what finds no such place is counted and dropped.
    /// </summary>
    /// <value>The default is 200.</value>
    public int MaxTracks { get; set; } = 200;

    /// <summary>
    /// Whether own reports that belong to a confirmed track go out to other vehicles, at most one a second and track.
    /// </summary>
    /// <value>The default is true.</value>
    public bool SharesReports { get; set; } = true;

    /// <summary>
    /// Whether the states of our tracks of targets that move go out to other vehicles, each every 10 s, and theirs are
    /// taken.
    /// </summary>
    /// <value>The default is false. A vehicle of a group does so.</value>
    public bool SharesTracks { get; set; }

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal SensorFusionOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Sensor Fusion: " + string.Join("; ", faults) + ".", parameter);
        return (SensorFusionOptions)MemberwiseClone();
    }

    /// <summary>A copy that also has what a mission says of the motions.</summary>
    internal SensorFusionOptions With(ImmutableDictionary<TargetClassName, TargetMotion> motions)
    {
        var made = (SensorFusionOptions)MemberwiseClone();
        made.TargetMotions = TargetMotions.SetItems(motions);
        return made;
    }

    /// <summary>A copy that also shares tracks.</summary>
    internal SensorFusionOptions WithSharedTracks()
    {
        var made = (SensorFusionOptions)MemberwiseClone();
        made.SharesTracks = true;
        return made;
    }

    internal IEnumerable<string> FindFaults()
    {
        if (!(Gate > 0 && Gate <= 100))
            yield return FormattableString.Invariant($"{nameof(Gate)} is {Gate}; it must be above 0 and at most 100");
        if (ConfirmOutOf is < 1 or > DetectionHistory.Capacity)
            yield return FormattableString.Invariant(
                $"{nameof(ConfirmOutOf)} is {ConfirmOutOf}; it must be 1 to {DetectionHistory.Capacity}");
        if (ConfirmHits < 1 || ConfirmHits > ConfirmOutOf)
            yield return FormattableString.Invariant(
                $"{nameof(ConfirmHits)} is {ConfirmHits}; it must be 1 to {nameof(ConfirmOutOf)}");
        if (LostAfterMisses < 1)
            yield return FormattableString.Invariant(
                $"{nameof(LostAfterMisses)} is {LostAfterMisses}; it must be at least 1");
        if (!(FootprintMarginMetres >= 0 && FootprintMarginMetres <= 1000))
            yield return FormattableString.Invariant(
                $"{nameof(FootprintMarginMetres)} is {FootprintMarginMetres}; it must be 0 to 1000 m");
        if (TentativeLifetime <= TimeSpan.Zero)
            yield return $"{nameof(TentativeLifetime)} is {TentativeLifetime}; it must be above zero";
        if (ReportGroupingDelay <= TimeSpan.Zero)
            yield return $"{nameof(ReportGroupingDelay)} is {ReportGroupingDelay}; it must be above zero";
        if (LateWindow < TimeSpan.Zero)
            yield return $"{nameof(LateWindow)} is {LateWindow}; it cannot be negative";
        if (TargetMotions is null || TargetMotions.Any(m => m.Key.IsNone || !IsMotion(m.Value)))
            yield return $"{nameof(TargetMotions)} is null, or has a class without a name or a motion that is none";
        if (!(RegistrationSigmaMetres >= 0 && RegistrationSigmaMetres <= 100))
            yield return FormattableString.Invariant(
                $"{nameof(RegistrationSigmaMetres)} is {RegistrationSigmaMetres}; it must be 0 to 100 m");
        if (MaxTracks is < 1 or > 1000)
            yield return FormattableString.Invariant($"{nameof(MaxTracks)} is {MaxTracks}; it must be 1 to 1000");
    }

    private static bool IsMotion(TargetMotion motion)
        => motion is TargetMotion.Standing or TargetMotion.Walking or TargetMotion.Vehicle;
}
