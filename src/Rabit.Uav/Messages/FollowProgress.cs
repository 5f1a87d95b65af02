namespace Rabit.Uav.Messages;

/// <summary>What the vehicle that follows a target does.</summary>
public enum FollowProgress
{
    /// <summary>It is on its way to the target.</summary>
    OnTheWay,

    /// <summary>Its own pictures show the target.</summary>
    InView,

    /// <summary>It has lost the target and searches for it.</summary>
    Searching,
}
