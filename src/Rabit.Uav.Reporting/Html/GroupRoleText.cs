using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>What a vehicle does for its group, in a few words.</summary>
internal static class GroupRoleText
{
    /// <summary>Empty where it has no role.</summary>
    public static string Of(in GroupRole role)
    {
        if (role.ValidatedFinder != 0)
            return $"validates {TargetClassNames.Name(role.ValidatedClass)} of {N(role.ValidatedFinder)}";
        if (role.FollowedFinder != 0)
            return $"follows {TargetClassNames.Name(role.FollowedClass)} of {N(role.FollowedFinder)}";
        LaneShare share = role.Share;
        if (share.SystemId == 0)
            return string.Empty;
        if (share.Count == 0)
            return "no lanes";
        return share.Count == 1
            ? $"lane {N(share.First + 1)}"
            : $"lanes {N(share.First + 1)} to {N(share.First + share.Count)}";
    }

    private static string N(long number) => FlightText.Number(number);
}
