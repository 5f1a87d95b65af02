using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Divides lanes among vehicles so that the last one has landed as early as possible: each has a run of neighbouring
/// lanes. The orders of up to five vehicles along the lanes are all tried; more of them are in the order in which they
/// stand. For each order the time is found by bisection.
/// </summary>
internal static class LaneDivider
{
    private const int MaxTriedMembers = 5;

    // A vehicle stops at the end of a lane, turns, and goes to the next one.
    private const double TurnSeconds = 8;

    private const double ToleranceSeconds = 0.5;

    /// <summary>One vehicle that takes lanes.</summary>
    /// <param name="SystemId">Its MAVLink system id.</param>
    /// <param name="Position">Where it is.</param>
    /// <param name="Speed">On the lanes, metres per second.</param>
    /// <param name="Seconds">How long it can search.</param>
    /// <param name="Landing">Where it lands after it; null where the way there does not count.</param>
    /// <param name="HeightSeconds">How long it climbs before and sinks after it.</param>
    /// <param name="LanesPerPass">For how many lanes beside each other it flies once.</param>
    public readonly record struct Member(
        byte SystemId, PlanePoint Position, double Speed, double Seconds, PlanePoint? Landing = null,
        double HeightSeconds = 0, int LanesPerPass = 1);

    /// <summary>Divides all lanes; the shares are in the order of the system ids.</summary>
    /// <param name="lanes">The lanes, in the order in which they lie.</param>
    /// <param name="metresLeft">What is left of each.</param>
    /// <param name="members">At least one.</param>
    /// <param name="isEnough">Whether the energy of each is enough for its share; else it was not looked at.</param>
    public static ImmutableArray<LaneShare> Divide(
        IReadOnlyList<LaneSegment> lanes, IReadOnlyList<double> metresLeft, IReadOnlyList<Member> members,
        out bool isEnough)
    {
        Member[] sorted = members.OrderBy(m => m.SystemId).ToArray();
        int[]? limited = Best(lanes, metresLeft, sorted, out Member[] order, isLimited: true);
        isEnough = limited is not null;
        int[] best = limited ?? Best(lanes, metresLeft, sorted, out order, isLimited: false)!;
        return order
            .Select((m, i) => new LaneShare(m.SystemId, i == 0 ? 0 : best[i - 1], best[i] - (i == 0 ? 0 : best[i - 1])))
            .OrderBy(s => s.SystemId).ToImmutableArray();
    }

    // The ends of the runs of the best order; null where the energy of all is not enough.
    private static int[]? Best(
        IReadOnlyList<LaneSegment> lanes, IReadOnlyList<double> left, Member[] members, out Member[] order,
        bool isLimited)
    {
        double most = members.Max(m => UpperBound(lanes, left, m));
        int[]? best = null;
        double least = double.PositiveInfinity;
        order = members;
        foreach (Member[] candidate in Orders(lanes, members))
        {
            // An order that is not faster than the best so far is not looked at any closer.
            double high = Math.Min(most, least - ToleranceSeconds);
            int[]? ends = Fill(lanes, left, candidate, high, isLimited);
            if (ends is null)
                continue;
            double low = 0;
            while (high - low > ToleranceSeconds)
            {
                double middle = (low + high) / 2;
                int[]? tried = Fill(lanes, left, candidate, middle, isLimited);
                (low, high, ends) = tried is null ? (middle, high, ends) : (low, middle, tried);
            }

            (best, least, order) = (ends, high, candidate);
        }

        return best;
    }

    // Each takes lanes as long as they can be flown within the time; null where some are left.
    private static int[]? Fill(
        IReadOnlyList<LaneSegment> lanes, IReadOnlyList<double> left, Member[] order, double seconds, bool isLimited)
    {
        var ends = new int[order.Length];
        int next = 0;
        for (int i = 0; i < order.Length; i++)
        {
            ends[i] = next = Fill(lanes, left, order[i], next, seconds, isLimited);
        }

        return next == lanes.Count ? ends : null;
    }

    // The end of the run of one that begins at a lane.
    private static int Fill(
        IReadOnlyList<LaneSegment> lanes, IReadOnlyList<double> left, Member member, int next, double seconds,
        bool isLimited)
    {
        double taken = 0;
        double home = double.PositiveInfinity;
        int inRun = 0;
        for (; next < lanes.Count; next++)
        {
            if (!(left[next] > 0))
            {
                // Its neighbours on both sides are flown as the first of a run.
                inRun = taken > 0 && inRun > 0 ? 1 : 0;
                continue;
            }

            double more = (IsFlown(inRun, member.LanesPerPass) ? SecondsOf(left[next], member) : 0)
                + (taken > 0 ? 0 : DistanceTo(lanes[next], left[next], member.Position) / member.Speed);
            home = Math.Min(home, HomeSeconds(lanes[next], member));
            bool isTooLate = taken + more + home + member.HeightSeconds > seconds;
            if (isTooLate || (isLimited && taken + more > member.Seconds))
                break;
            (taken, inRun) = (taken + more, inRun + 1);
        }

        return next;
    }

    // The first lane of a run, its last one, and between them those from which the others are seen.
    private static bool IsFlown(int inRun, int lanesPerPass)
        => inRun == 0 || lanesPerPass <= 1 || (inRun - 1) % lanesPerPass == 0;

    private static double HomeSeconds(LaneSegment lane, Member member)
        => member.Landing is { } landing ? DistanceTo(lane, landing) / member.Speed : 0;

    private static double UpperBound(IReadOnlyList<LaneSegment> lanes, IReadOnlyList<double> left, Member member)
    {
        double sum = 0;
        double far = 0;
        double home = 0;
        for (int i = 0; i < lanes.Count; i++)
        {
            sum += SecondsOf(left[i], member);
            far = Math.Max(far, DistanceTo(lanes[i], member.Position));
            home = Math.Max(home, HomeSeconds(lanes[i], member));
        }

        return sum + (far / member.Speed) + home + member.HeightSeconds + 1;
    }

    private static double SecondsOf(double metres, Member member) => (metres / member.Speed) + TurnSeconds;

    // Who is on it goes on from there.
    private static double DistanceTo(LaneSegment lane, double left, PlanePoint from)
        => left < lane.Length ? lane.DistanceTo(from) : DistanceTo(lane, from);

    private static double DistanceTo(LaneSegment lane, PlanePoint from)
        => Math.Min(lane.Start.DistanceTo(from), lane.End.DistanceTo(from));

    private static IEnumerable<Member[]> Orders(IReadOnlyList<LaneSegment> lanes, Member[] members)
    {
        if (members.Length <= MaxTriedMembers)
            return Permutations(members, members.Length);
        PlanePoint across = Middle(lanes[lanes.Count - 1]) - Middle(lanes[0]);
        Member[] asTheyStand = members.OrderBy(m => m.Position.Dot(across)).ThenBy(m => m.SystemId).ToArray();
        return [asTheyStand];
    }

    private static PlanePoint Middle(LaneSegment lane) => 0.5 * (lane.Start + lane.End);

    private static IEnumerable<Member[]> Permutations(Member[] members, int count)
    {
        if (count <= 1)
        {
            yield return (Member[])members.Clone();
            yield break;
        }

        for (int last = 0; last < count; last++)
        {
            var moved = (Member[])members.Clone();
            (moved[last], moved[count - 1]) = (moved[count - 1], moved[last]);
            foreach (Member[] order in Permutations(moved, count - 1))
                yield return order;
        }
    }
}
