namespace Rabit.Uav.Messages;

/// <summary>Results of the requests for message rates, since the start. A plain value.</summary>
/// <param name="accepted">Messages whose rate the autopilot accepted.</param>
/// <param name="refused">Messages whose rate it refused.</param>
/// <param name="unanswered">Messages for which no answer came to any attempt.</param>
/// <param name="sent">Requests that were handed to Communications, each attempt counted.</param>
public readonly struct RateRequestCounts(long accepted, long refused, long unanswered, long sent)
{
    /// <summary>Messages whose rate the autopilot accepted.</summary>
    public long Accepted { get; } = accepted;

    /// <summary>Messages whose rate it refused; they are asked for again after a reconnection or a reboot.</summary>
    public long Refused { get; } = refused;

    /// <summary>Messages for which no answer came to any attempt.</summary>
    public long Unanswered { get; } = unanswered;

    /// <summary>Requests that were handed to Communications, each attempt counted.</summary>
    public long Sent { get; } = sent;
}
