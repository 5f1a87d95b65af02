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

    /// <summary>How long after "temporarily rejected" it is sent again; 1 s.</summary>
    public TimeSpan RejectionPause { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How often "temporarily rejected" is taken for a reason to try again; 3. The next one is the refusal.</summary>
    public int Rejections { get; init; } = 3;

    /// <summary>
    /// How long after a sending its answer, or after an answer a copy of it, may still come in; 1 s. An acknowledgement names the command but not which sending of it:
    /// the next command of the same kind to the same component waits that long, and after an unknown outcome at least <see cref="ProgressTimeout"/>.
    /// </summary>
    public TimeSpan LateAnswerTime { get; init; } = TimeSpan.FromSeconds(1);

    /// <summary>How many commands may be under way, waiting, or waited for because of late answers, at once; 64.</summary>
    public int Capacity { get; init; } = 64;
}
