using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What carrying out commands came to, for the manager to take away.</summary>
internal sealed class CommandOutbox
{
    /// <summary>Frames for the autopilot.</summary>
    public Queue<MavlinkFrame> Frames { get; } = new();

    /// <summary>Answers for Mission Control.</summary>
    public Queue<VehicleCommandResult> Answers { get; } = new();

    /// <summary>Lines for the log.</summary>
    public Queue<string> Notes { get; } = new();
}
