using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Everything that is reported of several vehicles that searched one area together, for <see cref="GroupHtmlReport"/>.
/// Immutable.
/// </summary>
/// <example>
/// <code>
/// var group = new GroupFlightSummary([new GroupVehicleSummary(1, summary)])   // and those of the others
/// {
///     Name = "search of a meadow",
/// };
/// using StreamWriter page = File.CreateText("group-report.html");
/// GroupHtmlReport.Write(page, group);
/// </code>
/// </example>
public sealed class GroupFlightSummary
{
    /// <summary>Makes a summary.</summary>
    /// <param name="vehicles">The vehicles; they are kept in the order of their system ids.</param>
    /// <exception cref="ArgumentException">There is none.</exception>
    public GroupFlightSummary(IReadOnlyList<GroupVehicleSummary> vehicles)
    {
        if (vehicles is null)
            throw new ArgumentNullException(nameof(vehicles));
        if (vehicles.Count == 0)
            throw new ArgumentException("A group has at least one vehicle.", nameof(vehicles));
        Vehicles = vehicles.OrderBy(v => v.SystemId).ToArray();
        ValidationTask[] announced = Vehicles
            .SelectMany(v => v.Flight.Record.Group.Validations.Select(t => (Task: t, IsFinder: t.Finder == v.SystemId)))
            .GroupBy(t => (t.Task.Finder, t.Task.Session, t.Task.Number))
            .Select(g => g.OrderByDescending(t => t.IsFinder).ThenByDescending(t => t.Task.State)
                .ThenByDescending(t => t.Task.Award).First().Task)
            .Where(t => t.State != ValidationState.Closed || t.Validator != 0).ToArray();
        Validations = announced
            .Where((t, i) => TrackValidation.HasResult(t)
                ? !t.IsRejectedByOperator || !IsElsewhere(announced, i)
                : !announced.Any(o => TrackValidation.HasResult(o) && AreSame(t, o)))
            .ToArray();
        Followings = Vehicles.SelectMany(v => v.Flight.Record.Group.Followings)
            .GroupBy(t => (t.Finder, t.Session, t.Number))
            .Select(g => g.OrderByDescending(t => t.Result == FollowResult.Rejected)
                .ThenByDescending(t => t.Result == FollowResult.Followed)
                .ThenByDescending(t => t.Decision).ThenByDescending(t => t.InView).First())
            .Where(t => t.Result != FollowResult.SameTarget).ToArray();
        Coverage = Math.Max(
            Vehicles.Max(v => v.Flight.Record.Mission.Coverage),
            GroupCoverage.Of(Vehicles.Select(v => v.Flight.Record).ToArray()));
        var searches = new GroupSearches(Vehicles);
        (VehicleFailures, Remarks) = (searches.Failures.ToArray(), searches.Remarks.ToArray());
    }

    /// <summary>The vehicles, in the order of their system ids.</summary>
    public IReadOnlyList<GroupVehicleSummary> Vehicles { get; }

    /// <summary>
    /// The targets that were to be validated by a second vehicle, as their finders know them, of a finder that was lost
    /// as the others do; without those that were left to the task of another finder, or have no result where the
    /// task of another finder of the same target has one. What the operator rejected is there once.
    /// </summary>
    public IReadOnlyList<ValidationTask> Validations { get; }

    /// <summary>
    /// The targets that move and were to be followed, each as the vehicle knows it that knows the most; without those
    /// that turned out to be the target of another task.
    /// </summary>
    public IReadOnlyList<FollowTask> Followings { get; }

    /// <summary>
    /// The targets of a class that moves which no vehicle followed, as the vehicle knows them that knows the most;
    /// without false ones, where the truth is known.
    /// </summary>
    public IReadOnlyList<TargetTrack> NotFollowed => BestInformed.Flight.Record.Tracks.Tracks
        .Where(t => t.Motion != TargetMotion.Standing && t.State is TrackState.Confirmed or TrackState.Lost)
        .Where(t => FollowingsOf(t).Count == 0 && Score?.FalseTracks.Contains(t) != true)
        .OrderBy(t => t.Id).ToArray();

    /// <summary>How many of <see cref="Validations"/> a second vehicle confirmed.</summary>
    public int Confirmed => Validations.Count(
        t => t.State == ValidationState.Closed && t.Result == ValidationResult.Confirmed);

    /// <summary>
    /// How much of the area the pictures of all vehicles show together, 0 to 1; what one vehicle knows where that is
    /// more: of a long flight not every picture is recorded.
    /// </summary>
    public double Coverage { get; }

    /// <summary>What was flown, for the title; empty for no name.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>What was flown, for people.</summary>
    public string Source { get; init; } = string.Empty;

    /// <summary>The command line of the program; empty for none.</summary>
    public string CommandLine { get; init; } = string.Empty;

    /// <summary>The seed of a simulated world; null for a real one.</summary>
    public long? Seed { get; init; }

    /// <summary>From the first take-off to the last landing.</summary>
    public TimeSpan FlightTime { get; init; }

    /// <summary>
    /// The tracks of the vehicle that knows the most, compared with the truth, and what others take for targets that is
    /// none: see <see cref="WithFalseTracksOf"/>. Null where the truth is not known.
    /// </summary>
    public MissionScore? Score { get; init; }

    /// <summary>
    /// What failed of single vehicles, for people, without what the group made good: where one gave the search up, on
    /// command or with an empty battery, and the others completed it, that is a remark.
    /// </summary>
    public IReadOnlyList<string> VehicleFailures { get; }

    /// <summary>What happened and is no failure of the group, for people.</summary>
    public IReadOnlyList<string> Remarks { get; }

    /// <summary>
    /// What of it failed, for people; none where all was accomplished. Who makes the summary says so, with
    /// <see cref="VehicleFailures"/> among it.
    /// </summary>
    public IReadOnlyList<string> Failures { get; init; } = [];

    /// <summary>Whether the group did what was asked for.</summary>
    public bool HasPassed => Failures.Count == 0;

    /// <summary>
    /// A score with the false and rejected tracks of standing targets that only other vehicles have: it is enough that
    /// one of a group takes for a target what is none. Each is there once, and what a second vehicle rejected when it
    /// was asked is not among the false ones. Tracks of targets that move change with what each vehicle sees last, and
    /// are not added.
    /// </summary>
    /// <param name="score">Of the vehicle that knows the most.</param>
    /// <param name="others">Of the other vehicles.</param>
    public MissionScore WithFalseTracksOf(MissionScore score, IReadOnlyList<MissionScore> others)
    {
        if (score is null)
            throw new ArgumentNullException(nameof(score));
        if (others is null)
            throw new ArgumentNullException(nameof(others));
        List<TargetTrack> rejected = WithTracksOf(RejectedOf(score), others.SelectMany(RejectedOf));
        List<TargetTrack> all = WithTracksOf(
            score.FalseTracks.Where(t => !IsRejected(t)), others.SelectMany(s => s.FalseTracks).Where(
                t => !IsRejected(t) && !rejected.Exists(r => AreSame(r, t))));
        return new MissionScore
        {
            Targets = score.Targets,
            FalseTracks = all,
            RejectedTracks = rejected,
            IdentitySwitches = score.IdentitySwitches,
            DistanceFromHomeMetres = score.DistanceFromHomeMetres,
        };
    }

    /// <summary>
    /// Where a target is that was to be validated: by the track of the vehicle that knows the most, as the report shows
    /// it; where that has none, as its finder announced it.
    /// </summary>
    /// <param name="task">One of <see cref="Validations"/>.</param>
    public GeodeticPosition PositionOf(ValidationTask task) => BestInformed.Flight.Record.Tracks.Tracks
        .Where(t => t.State != TrackState.Tentative && TrackValidation.IsOf(t, task))
        .OrderBy(t => TrackValidation.Metres(t.Position, task.Position))
        .Select(t => (GeodeticPosition?)t.Position).FirstOrDefault() ?? task.Position;

    /// <summary>How a target that moves was followed, in a few words: "by vehicle 2, 31 s in view".</summary>
    /// <param name="task">One of <see cref="Followings"/>.</param>
    public string DescribeFollowing(FollowTask task) => FollowText.Of(task, FollowersOf(task));

    /// <summary>
    /// The vehicle whose tracks the report shows: that with the most confirmed ones, of these the lowest system id.
    /// </summary>
    internal GroupVehicleSummary BestInformed => Vehicles
        .FirstOrDefault(v => Score?.Targets.Any(t => t.Track is not null
            && v.Flight.Record.Tracks.Tracks.Contains(t.Track)) == true)
        ?? Vehicles.OrderByDescending(v => v.Flight.Record.Tracks.Confirmed.Count()).First();

    /// <summary>The task of a track; null where it was never announced. Of several one that has a result.</summary>
    internal ValidationTask? ValidationOf(TargetTrack track) => TrackValidation.Of(track, Validations);

    /// <summary>Those of <see cref="Followings"/> that were of a track of <see cref="BestInformed"/>.</summary>
    internal IReadOnlyList<FollowTask> FollowingsOf(TargetTrack track)
    {
        FollowedTrack[] links = BestInformed.Flight.Record.Group.FollowedTracks
            .Where(l => l.TrackId == track.Id).ToArray();
        return Followings.Where(t => Array.Exists(
            links, l => (l.Finder, l.Session, l.Number) == (t.Finder, t.Session, t.Number))).ToArray();
    }

    // Of what the operator rejected the task counts that was awarded before, since that is of its finder; else the
    // first.
    private static bool IsElsewhere(ValidationTask[] announced, int index) => announced
        .Where((o, i) => i != index && o.IsRejectedByOperator && AreSame(announced[index], o)
            && (o.Award > announced[index].Award || (o.Award == announced[index].Award && i < index)))
        .Any();

    private static bool AreSame(in ValidationTask a, in ValidationTask b) => a.Class == b.Class
        && a.MarkerId == b.MarkerId && TrackValidation.AreOnePlace(a.Position, b.Position);

    private static List<TargetTrack> WithTracksOf(IEnumerable<TargetTrack> own, IEnumerable<TargetTrack> others)
    {
        List<TargetTrack> all = [.. own];
        foreach (TargetTrack track in others.Where(t => t.Motion == TargetMotion.Standing))
        {
            if (!all.Exists(t => AreSame(t, track)))
                all.Add(track);
        }

        return all;
    }

    // Who validated may not have reached the vehicle whose track it is any more.
    private IEnumerable<TargetTrack> RejectedOf(MissionScore score)
        => score.RejectedTracks.Concat(score.FalseTracks.Where(IsRejected));

    private bool IsRejected(TargetTrack track)
        => ValidationOf(track) is { Result: ValidationResult.Rejected, IsRejectedByOperator: false };

    private static bool AreSame(TargetTrack a, TargetTrack b) => a.Class == b.Class && a.MarkerId == b.MarkerId
        && TrackValidation.AreOnePlace(a.Position, b.Position);

    // As their own roles say; the task names the last one alone.
    private byte[] FollowersOf(FollowTask task) => Vehicles
        .Select(v => (v.SystemId, Since: v.Flight.Record.GroupRoles
            .Where(r => r.FollowedFinder == task.Finder && r.FollowedNumber == task.Number)
            .Select(r => (TimeSpan?)(r.Time + v.ClockOffset)).FirstOrDefault()))
        .Where(v => v.Since is not null).OrderBy(v => v.Since).Select(v => v.SystemId)
        .Concat(task.Follower == 0 ? [] : [task.Follower]).Distinct().ToArray();
}
