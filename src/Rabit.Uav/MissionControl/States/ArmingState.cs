using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Arming, again and again while the autopilot's checks do not pass.</summary>
internal sealed class ArmingState() : MissionState(MissionPhase.Arming)
{
    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(3);

    // An autopilot that says yes has armed within a heartbeat or two.
    private static readonly TimeSpan ArmedWithin = TimeSpan.FromSeconds(5);

    public override void Enter(MissionFlight flight, MissionEvent by) => flight.Desk.WantNothing();

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.Want(VehicleCommandKind.Arm, "arm", RetryAfter);
        flight.Text = "arming" + (flight.Desk.LastFailure.Length > 0 ? "; " + flight.Desk.LastFailure : string.Empty);
        if (flight.Desk.IsAccepted && flight.Vehicle.IsArmed)
        {
            flight.MeasureGround();
            return new MissionStep(MissionEvent.Armed, $"ground at {MissionText.Of(flight.GroundAltitudeAmslMetres)} m above sea level");
        }

        if (inPhase > flight.Options.ArmWithin)
            return Impossible($"not armed within {MissionText.Seconds(flight.Options.ArmWithin)}: {flight.Desk.LastFailure}");
        if (flight.Desk.IsAccepted && flight.Now - flight.Desk.SentTime > ArmedWithin)
            flight.Desk.SendAgain();
        return MissionStep.Stay;
    }
}
