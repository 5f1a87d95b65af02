namespace Rabit.Uav.Messages;

/// <summary>How far the validation of a target by a second vehicle is.</summary>
public enum ValidationState
{
    /// <summary>The finder waits for bids.</summary>
    Open,

    /// <summary>One vehicle is to validate it.</summary>
    Awarded,

    /// <summary>It is over.</summary>
    Closed,
}
