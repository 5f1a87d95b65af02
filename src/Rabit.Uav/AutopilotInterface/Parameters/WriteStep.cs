using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Sets one parameter, until the autopilot reports the value; several tries.</summary>
internal sealed class WriteStep(MavlinkParameterClient client, string name, MavParamType type, double value) : SetupStep
{
    private const int MaxTries = 3;

    private int _tries;

    public override bool TryStart(TimeSpan now) => client.TryStartSet(name, type, value, now);

    public override bool TryFinish(TimeSpan now, out string? fault)
    {
        fault = null;
        if (!client.TryTakeOutcome(out MavlinkParameterOutcome outcome))
            return false;
        if (outcome.Status == MavlinkParameterStatus.Done)
            return true;
        if (++_tries < MaxTries)
        {
            TryStart(now);
            return false;
        }

        fault = outcome.Status == MavlinkParameterStatus.Refused
            ? $"the autopilot rejects {name}"
            : $"{name} is not confirmed";
        return true;
    }
}
