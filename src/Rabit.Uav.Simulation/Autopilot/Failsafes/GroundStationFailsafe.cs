using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// FS_GCS_ENABLE: the heartbeats of the ground station with the id of SYSID_MYGCS, once received, are missing for
/// FS_GCS_TIMEOUT. Those of a companion do not count.
/// </summary>
internal sealed class GroundStationFailsafe(
    ParameterStore parameters, FailsafeResponse response, Action<MavSeverity, string> say)
{
    private readonly LossTimer _heartbeats = new();

    public bool IsOn { get; private set; }

    public void Receive(byte systemId, TimeSpan time)
    {
        if (systemId == (byte)parameters.GroundSystemId.Value)
            _heartbeats.Receive(time);
    }

    public void Step(TimeSpan time)
    {
        if (parameters.GroundFailsafe.Value <= 0)
            return;
        bool isLost = _heartbeats.IsLost(time, parameters.GroundFailsafeTimeout.Value);
        if (isLost == IsOn)
            return;
        IsOn = isLost;
        if (isLost)
            response.Respond(FailsafeCause.GroundStation, Action());
        else
            say(MavSeverity.Warning, "GCS Failsafe Cleared");
    }

    private FailsafeAction Action() => (int)parameters.GroundFailsafe.Value switch
    {
        4 => FailsafeAction.SmartReturnOrLand,
        5 => FailsafeAction.Land,
        7 => FailsafeAction.BrakeOrLand,
        _ => FailsafeAction.Return,
    };
}
