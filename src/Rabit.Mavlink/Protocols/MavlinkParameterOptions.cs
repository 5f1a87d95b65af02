using System;

namespace Rabit.Mavlink;

/// <summary>Time-outs and retries of a <see cref="MavlinkParameterClient"/>. Immutable.</summary>
public sealed class MavlinkParameterOptions
{
    /// <summary>How long one try waits for an answer; 0.7 s.</summary>
    public TimeSpan AnswerTimeout { get; init; } = TimeSpan.OfSeconds(0.7);

    /// <summary>How often a read or set without an answer is sent again; 5.</summary>
    public int Retries { get; init; } = 5;

    /// <summary>How long a list may pause before the missing parameters are requested by index; 1 s.</summary>
    public TimeSpan GapTimeout { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>After how many consecutive rounds of requests without anything new a list is given up; 10.</summary>
    public int EmptyRounds { get; init; } = 10;

    /// <summary>How many missing parameters are requested at once; 16.</summary>
    public int RoundSize { get; init; } = 16;

    /// <summary>How often a list may turn out to have changed while it is read, before it is given up; 5.</summary>
    public int Restarts { get; init; } = 5;

    /// <summary>
    /// How long after a sending its answer may still arrive; 1 s. The next operation on the same parameter waits that
    /// long.
    /// </summary>
    public TimeSpan LateAnswerTime { get; init; } = TimeSpan.FromSeconds(1);
}
