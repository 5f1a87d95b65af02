using System;

namespace Rabit.Mavlink;

/// <summary>How patient a <see cref="MavlinkCommandClient"/> is. Immutable.</summary>
public sealed class MavlinkCommandOptions
{
    /// <summary>How long one try waits for an answer; 0.7 s. The guide leaves it open: MAVSDK and PX4 wait 0.5 s, a slow radio needs a little more.</summary>
    public TimeSpan AnswerTimeout { get; init; } = TimeSpan.FromSeconds(0.7);

    /// <summary>How often a command without any answer is sent again; 3.</summary>
    public int Retries { get; init; } = 3;

    /// <summary>How long to wait for the end of what is in progress, from each sign of progress; 5 s. It is not sent again meanwhile: that might do it twice.</summary>
    public TimeSpan ProgressTimeout { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Whether what was in progress, and then fell silent for the <see cref="ProgressTimeout"/>, is sent again by the tries that are left: right for commands that may
    /// be done twice, like a mode or a place. False unless told otherwise.
    /// </summary>
    public bool RetriesInProgress { get; init; }

    /// <summary>How long after "temporarily rejected" it is sent again; 1 s.</summary>
    public TimeSpan RejectionPause { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How often "temporarily rejected" is taken for a reason to try again; 3. The next one is the refusal.</summary>
    public int Rejections { get; init; } = 3;

    /// <summary>
    /// How long after a sending its answer, or after an answer a copy of it, may still come in; 1 s. An acknowledgement names the command but not which sending of it:
    /// the next command of the same kind to the same component waits that long, and after an unknown outcome at least <see cref="UnknownLateTime"/>.
    /// </summary>
    public TimeSpan LateAnswerTime { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How long after the last sending of a command with an unknown outcome its answer may still come in; 5 s.</summary>
    public TimeSpan UnknownLateTime { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Whether the link may double answers; true unless told otherwise. Where it is false, a command that got as many answers as it had sendings is done with at once,
    /// and the next of its kind does not wait.
    /// </summary>
    public bool AnswersMayDouble { get; init; } = true;

    /// <summary>How many commands may be under way, waiting, or waited for because of late answers, at once; 64.</summary>
    public int Capacity { get; init; } = 64;
}
