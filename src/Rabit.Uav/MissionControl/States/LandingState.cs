using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Landing: at home by the autopilot's own return, which needs no command, or at the present position.
/// </summary>
internal sealed class LandingState() : MissionState(MissionPhase.Landing)
{
    private const double TimeReserveSeconds = 120;
    private const double MinDescentRate = 0.3;

    // Autopilots disarm by themselves a few seconds after touchdown.
    private static readonly TimeSpan AutoDisarmTimeout = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(2);

    // For others of the group below: who flies a lane has passed by then.
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(10);

    private bool _isOurLanding;
    private bool _mayWait;
    private TimeSpan _limit;
    private TimeSpan? _onGround;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        _mayWait = by == MissionEvent.OperatorLand && !flight.IsFixedWing;
        _isOurLanding = by is MissionEvent.LandNow or MissionEvent.OperatorLand;
        _limit = Seconds(TimeReserveSeconds + (Math.Max(0, flight.HeightMetres) / MinDescentRate));
        _onGround = null;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.Text = $"landing: height {MissionNumbers.Of(flight.HeightMetres)} m"
            + (flight.Aborted is null ? string.Empty : "; " + flight.Aborted);
        if (flight.Touchdown.Stop == MotorStop.Landed)
            return new MissionStep(MissionEvent.Landed, LandedText(flight));
        if (!flight.Vehicle.IsArmed)
            return MissionStep.Stay;
        if (inPhase > _limit)
            return Impossible($"not landed within {MissionNumbers.Seconds(_limit)}");
        if (flight.Vehicle.LandedState != MavLandedState.OnGround)
        {
            _onGround = null;
            if (IsWaiting(flight, inPhase))
                flight.SetGoal(VehicleCommandKind.Hold, "hold", RetryAfter);
            else if (_isOurLanding)
                flight.SetGoal(VehicleCommandKind.Land, "land", RetryAfter);
            return MissionStep.Stay;
        }

        _onGround ??= flight.ActiveTime;
        if (flight.ActiveTime - _onGround.Value > AutoDisarmTimeout)
            flight.SetGoal(VehicleCommandKind.Disarm, "disarm", RetryAfter);
        return MissionStep.Stay;
    }

    // What the operator commands is not urgent by the second, as a failsafe may be; once it sinks it goes on.
    private bool IsWaiting(MissionFlight flight, TimeSpan inPhase)
    {
        if (!_mayWait || inPhase > MaxWait || flight.Plan is null || flight.Group?.FindBelow(flight) is not { } other)
            return _mayWait = false;
        flight.Text = $"landing: waits for vehicle {MissionNumbers.Of(other)}, which is below";
        return true;
    }

    private static string LandedText(MissionFlight flight)
    {
        if (!flight.Touchdown.IsPlaceKnown)
            return "landed at an unknown place";
        return flight.Plan is null
            ? $"landed after the operator's command; {flight.DistanceText}"
            : "landed " + flight.DistanceText;
    }
}
