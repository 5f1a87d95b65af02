namespace Rabit.Uav.Messages;

/// <summary>How far it is settled which vehicle of a group follows a target that moves.</summary>
public enum FollowState
{
    /// <summary>Bids are waited for. A vehicle that is named as the follower follows until it is relieved.</summary>
    Open,

    /// <summary>One vehicle follows it.</summary>
    Awarded,

    /// <summary>It is over.</summary>
    Closed,
}
