using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Replaces the fence of the autopilot; no items clear it.</summary>
internal sealed class FenceWriteStep(MavlinkMissionClient client, IReadOnlyList<FenceItem> items) : SetupStep
{
    public override bool TryStart(TimeSpan now)
    {
        if (items.Count == 0)
            return client.TryStartClear(MavMissionType.Fence, now);
        var sent = new MissionItemInt[items.Count];
        for (int i = 0; i < sent.Length; i++)
            sent[i] = items[i].ToItem();
        return client.TryStartUpload(MavMissionType.Fence, sent, now);
    }

    public override bool TryFinish(TimeSpan now, out string? fault)
    {
        fault = null;
        if (!client.TryTakeOutcome(out MavlinkMissionOutcome outcome))
            return false;
        if (outcome.Status != MavlinkMissionStatus.Done)
            fault = $"the autopilot does not take the fence: {Text(outcome)}";
        return true;
    }

    internal static string Text(in MavlinkMissionOutcome outcome)
        => outcome.Status == MavlinkMissionStatus.Unknown
            ? "it does not answer"
            : $"{outcome.Status} {outcome.Result?.ToString() ?? string.Empty}".TrimEnd();
}
