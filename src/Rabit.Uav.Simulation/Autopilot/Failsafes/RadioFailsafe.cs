using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>FS_THR_ENABLE: the remote control is not received.</summary>
internal sealed class RadioFailsafe(
    ParameterStore parameters, FailsafeResponse response, Action<MavSeverity, string> say)
{
    // RC_FS_TIMEOUT; 1.0 s after SIM_RC_FAIL in ap-rc-failsafe.
    private const double LossSeconds = 1;

    private readonly LossTimer _received = new();

    public bool IsOn { get; private set; }

    /// <param name="isReceived">Whether the remote control, or a ground station instead of it, is received.</param>
    /// <param name="time">Now.</param>
    public void Step(bool isReceived, TimeSpan time)
    {
        if (isReceived)
            _received.Receive(time);
        bool isLost = parameters.RadioFailsafe.Value > 0 && _received.IsLost(time, LossSeconds);
        if (isLost == IsOn)
            return;
        IsOn = isLost;
        if (isLost)
            response.Respond(FailsafeCause.Radio, Action());
        else
            say(MavSeverity.Warning, "Radio Failsafe Cleared");
    }

    private FailsafeAction Action() => (int)parameters.RadioFailsafe.Value switch
    {
        3 => FailsafeAction.Land,
        5 => FailsafeAction.SmartReturnOrLand,
        7 => FailsafeAction.BrakeOrLand,
        _ => FailsafeAction.Return,
    };
}
