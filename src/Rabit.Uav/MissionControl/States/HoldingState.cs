using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Holds the position: at the operator's command until the next one or until a failsafe acts; by our own decision for
/// a short time, in which the operator can decide otherwise, and then returns to launch.
/// </summary>
internal sealed class HoldingState() : MissionState(MissionPhase.Holding)
{
    // Time to read the reason and to command something else; the battery is used meanwhile.
    private static readonly TimeSpan MaxOwnHold = TimeSpan.FromSeconds(15);

    private string _reason = string.Empty;
    private bool _isOperators;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        _isOperators = by == MissionEvent.OperatorHold;
        _reason = reason;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.SetGoal(VehicleCommandKind.Hold, "hold");
        flight.Text = "holding: " + _reason;
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch("hold " + flight.Commands.LastFailure);
        return !_isOperators && inPhase > MaxOwnHold ? ReturnToLaunch(_reason) : MissionStep.Stay;
    }
}
