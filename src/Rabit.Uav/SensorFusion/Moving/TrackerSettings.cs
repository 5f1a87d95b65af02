using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// How the tracker of moving targets decides; the values were chosen on RU-MTT-1, seeds 1 to 10. Immutable.
/// </summary>
internal sealed record TrackerSettings
{
    /// <summary>The largest squared Mahalanobis distance at which a point can be of a track.</summary>
    /// <value>Chi-square, 99.9 %: with 99 % one point of a target in a hundred would be left out.</value>
    public double Gate { get; init; } = 13.8;

    /// <summary>How often a target goes for good, per second.</summary>
    public double DeathsPerSecond { get; init; } = 0.0005;

    /// <summary>How many targets come up, per square metre and scan.</summary>
    public double BirthDensity { get; init; } = 2e-8;

    /// <summary>The density of clutter is taken to be no lower than this, points per square metre and scan.</summary>
    public double MinClutterDensity { get; init; } = 2e-7;

    /// <summary>The probability of existence from which on a track is confirmed.</summary>
    public double Confirm { get; init; } = 0.99;

    /// <summary>
    /// By how much a confirmed track is preferred to others for a point that both may have, as a logarithm: a target
    /// that turns is far from where it is expected, and a track that began beside it would take its points away.
    /// </summary>
    public double ConfirmedBonus { get; init; } = 5;

    /// <summary>
    /// By how much, as a logarithm, it must be likelier that two tracks that met have exchanged their points than that
    /// they have not, for the exchange to be undone.
    /// </summary>
    public double ExchangeMargin { get; init; } = 2;

    /// <summary>How much steadier than else targets are taken to go on where they meet.</summary>
    /// <value>
    /// By this factor the white acceleration is less; chosen on all seeds of <c>CrossingTests</c>, as the margin.
    /// </value>
    public double MeetingNoise { get; init; } = 0.1;

    /// <summary>In how many of the last <see cref="ConfirmOutOf"/> looks it must have been reported, too.</summary>
    public int ConfirmHits { get; init; } = 3;

    /// <summary>See <see cref="ConfirmHits"/>.</summary>
    public int ConfirmOutOf { get; init; } = 6;

    /// <summary>Below this probability a confirmed track is deleted.</summary>
    public double Delete { get; init; } = 0.01;

    /// <summary>
    /// How often a target of an established track goes out of sight behind or under something, per second.
    /// </summary>
    public double HidesPerSecond { get; init; } = 0.002;

    /// <summary>How often one that is out of sight comes back into it, per second.</summary>
    public double AppearsPerSecond { get; init; } = 0.05;

    /// <summary>
    /// A confirmed track of so many points is established: only such a one may be occluded. Clutter that was confirmed
    /// has fewer.
    /// </summary>
    public int EstablishedPoints { get; init; } = 10;

    /// <summary>A track that is this much likelier out of sight than in it is occluded.</summary>
    /// <value>A target that is reported with 90 % is missed so often in a row once in 10 000 looks.</value>
    public double OccludedRatio { get; init; } = 9;

    /// <summary>
    /// An occluded track that is less certain than this, standard deviation along the worst axis, takes no single
    /// point, since that may be clutter, but goes on with a track that begins, once that is confirmed.
    /// </summary>
    public double MaxSigmaForAPointMetres { get; init; } = 3;

    /// <summary>An occluded track is deleted this long after its last point.</summary>
    public TimeSpan MaxOccluded { get; init; } = TimeSpan.FromSeconds(30);

    /// <summary>
    /// An occluded track that is less certain than this, standard deviation along the worst axis, is deleted: it would
    /// take any point of its class for its target.
    /// </summary>
    public double MaxOccludedSigmaMetres { get; init; } = 60;

    /// <summary>
    /// A track that was never confirmed is deleted when it is less likely than at its start by this factor.
    /// </summary>
    public double DeleteTentative { get; init; } = 0.03;

    /// <summary>After so long without a point a track that was never confirmed is deleted, seen or not.</summary>
    public TimeSpan TentativeLifetime { get; init; } = TimeSpan.FromSeconds(20);

    /// <summary>A track that is less certain than this, standard deviation along the worst axis, is deleted.</summary>
    public double MaxSigmaMetres { get; init; } = 150;

    /// <summary>How far inside a footprint a track must be to count as seen, metres, beside twice its sigma.</summary>
    public double FootprintMarginMetres { get; init; } = 1;

    /// <summary>
    /// A track of another vehicle is of use where it is newer than ours by this: before, ours has reports of both.
    /// </summary>
    public TimeSpan EstimateNewerBy { get; init; } = TimeSpan.FromSeconds(2);

    /// <summary>How many tracks there may be.</summary>
    public int MaxTracks { get; init; } = 200;

    /// <summary>How many points of one scan are used.</summary>
    public int MaxPoints { get; init; } = 1000;

    /// <summary>How late a point may be.</summary>
    public TimeSpan Window { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>How many points a track keeps to be filtered again.</summary>
    public int KeptPoints { get; init; } = 64;
}
