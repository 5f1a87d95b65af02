using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Takes what Autopilot Interface sends to other managers than Communications, in their place.</summary>
internal sealed class AutopilotPeers : RabitManager
{
    private readonly QueueReceiver<PoseSample> _poses;
    private readonly QueueReceiver<VehicleCommandResult> _answers;

    public AutopilotPeers()
        : base("peers")
    {
        _poses = Receive<PoseSample>(MessageNames.Poses, 1000, QueueFullMode.DropOldest);
        _answers = Receive<VehicleCommandResult>(MessageNames.VehicleCommandResults);
    }

    public List<PoseSample> Poses { get; } = [];

    public List<VehicleCommandResult> Answers { get; } = [];

    /// <summary>Whether it keeps the poses.</summary>
    public bool KeepsPoses { get; set; } = true;

    protected override void ExecuteUnitOfWork()
    {
        while (_poses.TryPop(out PoseSample pose))
        {
            if (KeepsPoses)
                Poses.Add(pose);
        }

        while (_answers.TryPop(out VehicleCommandResult answer))
            Answers.Add(answer);
    }
}
