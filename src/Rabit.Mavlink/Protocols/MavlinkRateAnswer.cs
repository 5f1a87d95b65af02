namespace Rabit.Mavlink;

/// <summary>
/// How a vehicle answered the request of a rate. It may accept and send less: what counts is the measured rate.
/// </summary>
public enum MavlinkRateAnswer
{
    /// <summary>No answer yet.</summary>
    None,

    /// <summary>Accepted.</summary>
    Accepted,

    /// <summary>Refused.</summary>
    Refused,

    /// <summary>No answer to any try.</summary>
    Unanswered,
}
