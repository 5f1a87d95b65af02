namespace Rabit.Uav.Messages;

/// <summary>What became of an operator's request. Once it is answered the answer stays.</summary>
public enum OperatorOutcome
{
    /// <summary>It waits, for the vehicle to be connected, say, or is being carried out.</summary>
    InProgress,

    /// <summary>It was carried out, or what it asked for has begun.</summary>
    Accepted,

    /// <summary>It was not carried out; the text says why.</summary>
    Refused,
}
