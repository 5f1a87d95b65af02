namespace Rabit.Uav.Messages;

/// <summary>Whether a vehicle of a group can search.</summary>
public enum GroupMemberState
{
    /// <summary>It waits on the ground, or holds: it searches later, or not at all.</summary>
    Waiting,

    /// <summary>It flies the mission, and takes lanes.</summary>
    Available,

    /// <summary>It returns, lands, has landed, or another one than Mission Control flies it.</summary>
    Leaving,

    /// <summary>It follows a target that moves: its lanes are for others.</summary>
    Following,
}
