namespace Rabit.Mavlink;

/// <summary>What a vehicle said to a request of a rate. It may say yes and send less: what counts is the measured rate.</summary>
public enum MavlinkRateAnswer
{
    /// <summary>Nothing yet.</summary>
    None,

    /// <summary>Accepted.</summary>
    Accepted,

    /// <summary>Refused.</summary>
    Refused,

    /// <summary>Nothing, to all tries.</summary>
    Unanswered,
}
