using System;

namespace Rabit.Mavlink;

/// <summary>
/// Time-outs and retries of a <see cref="MavlinkMissionClient"/>; the times are those of the MAVLink guide ("Mission
/// Protocol"). Immutable.
/// </summary>
public sealed class MavlinkMissionOptions
{
    /// <summary>How long one try waits for an answer; 1.5 s.</summary>
    public TimeSpan AnswerTimeout { get; init; } = TimeSpan.OfSeconds(1.5);

    /// <summary>How long one request of an item waits; 0.25 s. A slow radio needs more.</summary>
    public TimeSpan ItemTimeout { get; init; } = TimeSpan.OfSeconds(0.25);

    /// <summary>
    /// How often something is sent again without progress; 5. With a fifth of the frames lost a hundred items need some
    /// ten.
    /// </summary>
    public int Retries { get; init; } = 5;

    /// <summary>
    /// How long after a sending its answer may still arrive; 1 s. Answers do not say which transfer they are for: the
    /// next one waits that long.
    /// </summary>
    public TimeSpan LateAnswerTime { get; init; } = TimeSpan.FromSeconds(1);
}
