using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Reads the fence that the autopilot has.</summary>
internal sealed class FenceReadStep(MavlinkMissionClient client, Action<IReadOnlyList<FenceItem>> taken) : SetupStep
{
    public override bool TryStart(TimeSpan now) => client.TryStartDownload(MavMissionType.Fence, now);

    public override bool TryFinish(TimeSpan now, out string? fault)
    {
        fault = null;
        if (!client.TryTakeOutcome(out MavlinkMissionOutcome outcome))
            return false;
        if (outcome.Status != MavlinkMissionStatus.Done)
        {
            fault = $"the autopilot's fence cannot be read: {FenceWriteStep.Text(outcome)}";
            return true;
        }

        var items = new List<FenceItem>();
        foreach (MissionItemInt item in client.Items)
            items.Add(FenceItem.From(item));
        taken(items);
        return true;
    }
}
