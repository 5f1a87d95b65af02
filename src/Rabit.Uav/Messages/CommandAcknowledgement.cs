using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>What a vehicle answered to a command (COMMAND_ACK). Immutable.</summary>
public sealed class CommandAcknowledgement
{
    /// <summary>Makes one.</summary>
    /// <param name="time">When it came in, by the clock of the run.</param>
    /// <param name="command">The command.</param>
    /// <param name="result">The answer.</param>
    /// <param name="targetSystem">Whom the answer is for; 0 for all.</param>
    /// <param name="targetComponent">Whom the answer is for; 0 for every component.</param>
    public CommandAcknowledgement(
        TimeSpan time, MavCmd command, MavResult result, byte targetSystem, byte targetComponent)
    {
        Time = time;
        Command = command;
        Result = result;
        TargetSystem = targetSystem;
        TargetComponent = targetComponent;
    }

    /// <summary>When it came in, by the clock of the run.</summary>
    public TimeSpan Time { get; }

    /// <summary>The command.</summary>
    public MavCmd Command { get; }

    /// <summary>The answer.</summary>
    public MavResult Result { get; }

    /// <summary>Whom the answer is for; 0 for all.</summary>
    public byte TargetSystem { get; }

    /// <summary>Whom the answer is for; 0 for every component.</summary>
    public byte TargetComponent { get; }
}
