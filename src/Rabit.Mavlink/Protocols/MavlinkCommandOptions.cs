using System;

namespace Rabit.Mavlink;

/// <summary>Time-outs and retries of a <see cref="MavlinkCommandClient"/>. Immutable.</summary>
public sealed class MavlinkCommandOptions
{
    /// <summary>
    /// How long one try waits for an answer; 0.7 s. The guide leaves it open: MAVSDK and PX4 wait 0.5 s, a slow radio
    /// needs a little more.
    /// </summary>
    public TimeSpan AnswerTimeout { get; init; } = TimeSpan.OfSeconds(0.7);

    /// <summary>
    /// How often a command without any answer is sent again; 3. Copies sent after TEMPORARILY_REJECTED to a copy count
    /// too.
    /// </summary>
    public int Retries { get; init; } = 3;

    /// <summary>
    /// How long to wait for the final answer of a command in progress, from each IN_PROGRESS; 5 s. It is not sent again
    /// meanwhile: it might be executed twice.
    /// </summary>
    public TimeSpan ProgressTimeout { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Whether a command in progress, of which nothing was received for the <see cref="ProgressTimeout"/>, is sent
    /// again by the remaining tries: right for commands that may be executed twice, like a mode or a location. False by
    /// default.
    /// </summary>
    public bool RetriesInProgress { get; init; }

    /// <summary>How long after TEMPORARILY_REJECTED it is sent again; 1 s.</summary>
    public TimeSpan RejectionPause { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How many TEMPORARILY_REJECTED are a reason to try again; 3. The next one is the refusal.</summary>
    public int Rejections { get; init; } = 3;

    /// <summary>
    /// How long after a sending its answer, or after an answer a duplicate of it, may still arrive; 1 s. An
    /// acknowledgement names the command but not which sending of it: the next command of the same kind to the same
    /// component waits that long, and after an unknown outcome at min <see cref="UnknownLateTime"/>.
    /// </summary>
    public TimeSpan LateAnswerTime { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>
    /// How long after the last sending of a command with an unknown outcome its answer may still arrive; 5 s.
    /// </summary>
    public TimeSpan UnknownLateTime { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Whether the link may duplicate answers; true by default. Where it is false, a command that received as many
    /// answers as it had sendings is finished at once, and the next of its kind does not wait.
    /// </summary>
    public bool AnswersMayBeDuplicated { get; init; } = true;

    /// <summary>
    /// How many commands may be under way, waiting, or waited for because of late answers, at once; 64.
    /// </summary>
    public int Capacity { get; init; } = 64;
}
