using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>How a target that moves was followed, in a few words.</summary>
internal static class FollowText
{
    /// <param name="task">The target.</param>
    /// <param name="followers">System ids of the vehicles that were to follow it, one after the other.</param>
    public static string Of(in FollowTask task, IReadOnlyList<byte> followers)
    {
        if (task.Result == FollowResult.Rejected && (followers.Count == 0 || task.InView <= TimeSpan.Zero))
            return "no: rejected by the operator";
        if (followers.Count == 0)
            return task.State == FollowState.Closed ? "no: no vehicle could" : "no: none until the end";
        string by = (followers.Count == 1 ? "by vehicle " : "by vehicles ")
            + string.Join(", ", followers.Select(f => FlightText.Number((long)f)));
        string seen = FlightText.Number(task.InView.TotalSeconds, "0") + " s in view";
        return task.Result switch
        {
            FollowResult.Followed => $"{by}, {seen}",
            FollowResult.Rejected => $"{by}, {seen}, then rejected by the operator",
            FollowResult.Lost when task.InView > TimeSpan.Zero => $"{by}, {seen}, then lost",
            FollowResult.Lost => $"no: {by}, which did not find it",
            _ => $"{by} until the end, {seen}",
        };
    }
}
