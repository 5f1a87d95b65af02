namespace Rabit.Uav.Messages;

/// <summary>What a vehicle says to a target that another one wants validated.</summary>
public enum ValidationBidState
{
    /// <summary>It can do it.</summary>
    Offered,

    /// <summary>It cannot do it.</summary>
    Declined,

    /// <summary>It was awarded, and does it.</summary>
    Underway,

    /// <summary>It has done it.</summary>
    Finished,
}
