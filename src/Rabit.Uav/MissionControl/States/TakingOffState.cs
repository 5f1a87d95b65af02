using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Takes off and climbs to the height of the search.</summary>
internal sealed class TakingOffState() : MissionState(MissionPhase.TakingOff)
{
    // Autopilots end a take-off a little below the commanded height.
    private const double HeightToleranceMetres = 1;
    private const double HeightFraction = 0.95;

    private const double MinClimbRate = 0.7;
    private const double TimeReserveSeconds = 30;
    private const int MaxStarts = 3;

    private static readonly TimeSpan LiftOffTimeout = TimeSpan.FromSeconds(8);

    private int _starts;
    private bool _hasFlown;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        _starts++;
        _hasFlown = false;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        double height = flight.Plan!.HeightAboveHome(at: default, flight.Mission.HeightMetres);
        _hasFlown |= flight.IsFlying;
        var command = new VehicleCommand { Kind = VehicleCommandKind.TakeOff, HeightAboveHomeMetres = height };
        if (!flight.Commands.IsGoal(command))
            flight.Commands.SetGoal(command, $"take off to {MissionNumbers.Of(height)} m", TimeSpan.FromSeconds(2));
        flight.Text = $"taking off: {MissionNumbers.Of(flight.HeightMetres)} of {MissionNumbers.Of(height)} m";

        if (!flight.Vehicle.IsArmed)
        {
            if (_hasFlown)
                return Impossible($"the motors stopped at a height of {MissionNumbers.Of(flight.HeightMetres)} m");
            return _starts < MaxStarts
                ? new MissionStep(MissionEvent.Disarmed, "the autopilot stopped the motors on the ground")
                : Impossible($"the autopilot stopped the motors on the ground {MissionNumbers.Of(MaxStarts)} times");
        }

        if (flight.HeightMetres >= height - HeightToleranceMetres || flight.HeightMetres >= HeightFraction * height)
            return new MissionStep(MissionEvent.AtHeight, $"height {MissionNumbers.Of(flight.HeightMetres)} m");
        if (flight.Commands.Failures >= MaxFailures)
            return GiveUp(flight, "take-off " + flight.Commands.LastFailure);
        if (inPhase > Seconds(TimeReserveSeconds + (height / MinClimbRate)))
        {
            return GiveUp(
                flight,
                $"only {MissionNumbers.Of(flight.HeightMetres)} of {MissionNumbers.Of(height)} m reached in "
                    + $"{MissionNumbers.Seconds(inPhase)}");
        }

        if (!_hasFlown && flight.Commands.IsAccepted && flight.Now - flight.Commands.SentTime > LiftOffTimeout)
            flight.Commands.Resend();
        return MissionStep.Stay;
    }

    private static MissionStep GiveUp(MissionFlight flight, string reason)
        => flight.IsFlying ? ReturnToLaunch(reason) : Impossible(reason);
}
