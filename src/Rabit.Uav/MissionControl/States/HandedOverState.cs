using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The command was taken away, or never was ours: nothing is commanded. Only the operator's command gives control back:
/// then the command of the vehicle is taken first, and what he commanded is done once it is ours.
/// </summary>
internal sealed class HandedOverState() : MissionState(MissionPhase.HandedOver)
{
    // The autopilot is asked up to three times, and its answers may be lost.
    private static readonly TimeSpan MaxTakeTime = TimeSpan.FromSeconds(20);

    private bool _isOver;
    private TimeSpan _asked;

    /// <summary>Whether the motors are off: then nothing can be resumed.</summary>
    public override bool IsOver => _isOver;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        // What was asked for before is no answer to who took the command.
        if (by == MissionEvent.TakenOver)
            flight.Operator.RefuseAll("the command was taken away");
        flight.Commands.Clear();
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        _isOver = flight.IsConnected && !flight.Vehicle.IsArmed;
        if (flight.Operator.Pending is not null && flight.IsConnected)
            Take(flight);
        if (flight.Operator.InHand is not { } asked)
            return MissionStep.Stay;
        if (!flight.IsConnected || _isOver || flight.Commands.Failures >= MaxFailures
            || flight.Now - _asked > MaxTakeTime)
        {
            string why = !flight.IsConnected ? "no autopilot connected"
                : _isOver ? "the motors are off"
                : flight.Commands.Failures > 0 ? flight.Commands.LastFailure
                : "the autopilot does not answer";
            flight.Operator.RefuseInHand("the command of the vehicle was not taken, " + why);
            flight.Commands.Clear();
            return MissionStep.Stay;
        }

        flight.SetGoal(VehicleCommandKind.TakeControl, "take control");
        bool isOurs = flight.Commands.IsAccepted && flight.Authority.State == CommandAuthorityState.Ours;
        if (isOurs)
            flight.ControlGivenTime = flight.Now;
        return isOurs ? OperatorRules.ToStep(asked) : MissionStep.Stay;
    }

    private void Take(MissionFlight flight)
    {
        if (!flight.IsFlying)
        {
            flight.Operator.Refuse("the vehicle is not flying");
        }
        else if (FindFault(flight, flight.Operator.Pending!.Command) is { } fault)
        {
            flight.Operator.Refuse(fault);
        }
        else
        {
            flight.Operator.Begin();
            _asked = flight.Now;
        }
    }

    // Its modes are never taken but from our own return.
    private static string? FindFaultOfFixedWing(MissionFlight flight, OperatorCommand command)
        => command == OperatorCommand.Hold
            ? FixedWingRules.FindNotGiven(flight)
            : FixedWingRules.FindFault(flight) ?? FixedWingRules.FindMissing(flight);

    // As in flight: a hold or a resume against a reason to return would last for one tick. But a critical state may be
    // that of the failsafe that a hold ends.
    private static string? FindFault(MissionFlight flight, OperatorCommand command)
    {
        if (command == OperatorCommand.Return)
            return null;
        if (flight.Health.Advice != HealthAdvice.None)
            return flight.Health.AdviceText ?? flight.Health.Text ?? "health advises against it";
        if (flight.IsFixedWing && FindFaultOfFixedWing(flight, command) is { } fixedWing)
            return fixedWing;
        if (command == OperatorCommand.Hold)
            return null;
        if (MissionGuards.FindCritical(flight) is { } critical)
            return critical + "; a hold comes first";
        if (!flight.HasFreshPosition)
            return "no position";
        return flight.Plan is null ? flight.PlanInFlight() : null;
    }
}
