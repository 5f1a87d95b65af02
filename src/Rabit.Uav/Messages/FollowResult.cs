namespace Rabit.Uav.Messages;

/// <summary>How the following of a target ended.</summary>
public enum FollowResult
{
    /// <summary>It has not ended.</summary>
    None,

    /// <summary>It was in view for as long as the mission says.</summary>
    Followed,

    /// <summary>It was lost and not found again, or no vehicle could follow it before it was gone.</summary>
    Lost,

    /// <summary>It is the target of another task, which goes on.</summary>
    SameTarget,

    /// <summary>The operator of a vehicle has rejected it.</summary>
    Rejected,
}
