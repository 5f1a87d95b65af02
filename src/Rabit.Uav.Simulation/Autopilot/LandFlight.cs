using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>LAND, and the last part of RTL: straight down, slower near the ground, until it stands.</summary>
internal sealed class LandFlight : FlightMode
{
    // LAND_WITH_DELAY_MS of ArduCopter.
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(4);

    private NedVector _place;
    private TimeSpan _descendsAt;

    /// <summary>Whether the next entry waits before the descent.</summary>
    public bool PausesFirst { get; set; }

    public override bool IsLanding => true;

    public override bool DisarmsWhenLanded => true;

    public override void Enter(FlightSituation situation)
    {
        _place = situation.StoppingPoint;
        _descendsAt = PausesFirst ? situation.Time + Pause : TimeSpan.Zero;
    }

    /// <summary>Lands at a place instead of where it is.</summary>
    public void EnterAt(NedVector place) => _place = place;

    public override void Fly(FlightSituation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        ParameterStore parameters = situation.Parameters;
        NedVector velocity = VelocityTo(situation, _place);
        command.KeepsLevel = !situation.HasPosition;
        if (situation.Time < _descendsAt)
        {
            command.Velocity = new NedVector(velocity.North, velocity.East, 0);
            return;
        }

        double high = parameters.LandSpeedHigh.Value > 0 ? parameters.LandSpeedHigh.Value : parameters.SpeedDown.Value;

        // Without a position it does not slow down: ap-gps-ekf-failsafe.
        bool isHigh = !situation.HasPosition || situation.Height > parameters.LandLowHeight.Value / 100;
        double down = isHigh ? high : parameters.LandSpeed.Value;
        command.Velocity = new NedVector(velocity.North, velocity.East, down / 100);
    }
}
