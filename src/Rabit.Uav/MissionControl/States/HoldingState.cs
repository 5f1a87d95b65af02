using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Holds the position: at the operator's command until the next one or until a failsafe acts; by the advice of Health
/// Monitoring until that ends; by our own decision for a short time, in which the operator can decide otherwise, and
/// then returns to launch.
/// </summary>
internal sealed class HoldingState() : MissionState(MissionPhase.Holding)
{
    // Time to read the reason and to command something else; the battery is used meanwhile.
    private static readonly TimeSpan MaxOwnHold = TimeSpan.FromSeconds(15);

    // What has not ended by then is not expected to; the battery is used meanwhile.
    private static readonly TimeSpan MaxHealthHold = TimeSpan.FromMinutes(2);

    private string _reason = string.Empty;
    private MissionEvent _by;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        (_by, _reason) = (by, reason);
        flight.IsHeldByHealth = by == MissionEvent.HealthHold;
    }

    public override void Leave(MissionFlight flight) => flight.IsHeldByHealth = false;

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.SetGoal(VehicleCommandKind.Hold, "hold");
        flight.Text = "holding: " + _reason;
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch("hold " + flight.Commands.LastFailure);
        return _by switch
        {
            MissionEvent.OperatorHold => MissionStep.Stay,
            MissionEvent.HealthHold when inPhase > MaxHealthHold => ReturnToLaunch(_reason),
            MissionEvent.HealthHold => flight.Health.Advice == HealthAdvice.None && !flight.IsStopRequested
                ? new MissionStep(MissionEvent.HealthHoldOver, "over: " + _reason)
                : MissionStep.Stay,
            _ => inPhase > MaxOwnHold ? ReturnToLaunch(_reason) : MissionStep.Stay,
        };
    }
}
