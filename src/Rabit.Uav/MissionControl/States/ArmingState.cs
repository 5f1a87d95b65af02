using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Arms, again and again while the autopilot's pre-arm checks do not pass.</summary>
internal sealed class ArmingState() : MissionState(MissionPhase.Arming)
{
    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(3);

    // An autopilot that accepts the command has armed within a heartbeat or two.
    private static readonly TimeSpan AcceptedToArmedTimeout = TimeSpan.FromSeconds(5);

    public override void Enter(MissionFlight flight, MissionEvent by, string reason) => flight.Commands.Clear();

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.SetGoal(VehicleCommandKind.Arm, "arm", RetryAfter);
        flight.Text = "arming"
            + (flight.Commands.LastFailure.Length > 0 ? "; " + flight.Commands.LastFailure : string.Empty);
        if (flight.Commands.IsAccepted && flight.Vehicle.IsArmed)
        {
            flight.MeasureGround();
            return new MissionStep(
                MissionEvent.Armed,
                $"ground at {MissionNumbers.Of(flight.GroundAltitudeAmslMetres)} m above mean sea level");
        }

        if (inPhase > flight.Options.ArmTimeout)
            return Impossible(
                $"not armed within {MissionNumbers.Seconds(flight.Options.ArmTimeout)}: {flight.Commands.LastFailure}");
        if (flight.Commands.IsAccepted && flight.Now - flight.Commands.SentTime > AcceptedToArmedTimeout)
            flight.Commands.Resend();
        return MissionStep.Stay;
    }
}
