namespace Rabit.Uav.Messages;

/// <summary>What the pictures of a second vehicle say of a target.</summary>
public enum ValidationResult
{
    /// <summary>Nothing yet, or too little.</summary>
    Unknown,

    /// <summary>It was seen there again.</summary>
    Confirmed,

    /// <summary>
    /// The place was seen, and no such target; or the operator has rejected it
    /// (<see cref="ValidationTask.IsRejectedByOperator"/>).
    /// </summary>
    Rejected,
}
