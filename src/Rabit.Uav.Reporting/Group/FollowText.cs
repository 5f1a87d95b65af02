using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>How a target that moves was followed, in a few words.</summary>
internal static class FollowText
{
    public static string Of(FollowTask task)
    {
        string seen = FlightText.Number(task.InView.TotalSeconds, "0") + " s in view";
        return task.Result switch
        {
            FollowResult.Followed => $"by vehicle {FlightText.Number((long)task.Follower)}, {seen}",
            FollowResult.Lost when task.InView > TimeSpan.Zero => $"lost, {seen}",
            FollowResult.Lost => "no vehicle could",
            _ => task.Follower == 0 ? "none yet"
                : $"by vehicle {FlightText.Number((long)task.Follower)} until the end, {seen}",
        };
    }
}
