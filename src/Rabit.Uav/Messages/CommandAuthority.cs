using System;

namespace Rabit.Uav.Messages;

/// <summary>Whether we command the vehicle, as Autopilot Interface knows it. A plain value.</summary>
public struct CommandAuthority
{
    /// <summary>Who commands.</summary>
    public CommandAuthorityState State { get; set; }

    /// <summary>What took the command away from us, for people ("mode LOITER"); null where nothing did.</summary>
    public string? TakenBy { get; set; }

    /// <summary>The kind of what took it away; None where nothing did.</summary>
    public TakeoverCause Cause { get; set; }

    /// <summary>
    /// Whether Autopilot Interface returns to launch by itself, because the commands of Mission Control were no longer
    /// renewed.
    /// </summary>
    public bool IsReturningByItself { get; set; }

    /// <summary>Since when, by the clock of the run.</summary>
    public TimeSpan Since { get; set; }
}
