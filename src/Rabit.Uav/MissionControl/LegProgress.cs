using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Whether the vehicle comes nearer to the point that it was commanded to: where it does not, the leg is commanded
/// again once; then it holds. Progress is a smaller distance, and while it turns round also a rising speed towards the
/// point.
/// </summary>
internal sealed class LegProgress
{
    // From here on the vehicle brakes, and holds against the wind.
    private const double NearMetres = 5;
    private const double ProgressMetres = 0.5;
    private const double ProgressMetresPerSecond = 0.5;
    private const double FastMetresPerSecond = 3;
    private const double BrakingMetresPerSecondSquared = 1.5;

    private static readonly TimeSpan MaxTimeFast = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan MaxTimeSlow = TimeSpan.FromSeconds(5);

    private PlanePoint _to;
    private double _height;
    private bool _isWatching;
    private bool _wasCommandedAgain;
    private double _least;
    private double _slowest;
    private TimeSpan _since;
    private TimeSpan _turnsUntil;

    /// <summary>In the phases in which legs are flown, while the vehicle can be commanded.</summary>
    public MissionStep Check(MissionFlight flight)
    {
        if (!flight.Commands.IsAccepted || flight.Commands.GoalKind != VehicleCommandKind.GoTo)
        {
            _isWatching = false;
            return MissionStep.Stay;
        }

        (double distance, double closing) = Approach(flight);
        if (!_isWatching || distance < NearMetres || IsNewLeg(flight))
        {
            Begin(flight, distance, closing);
            return MissionStep.Stay;
        }

        bool isNearer = distance <= _least - ProgressMetres;
        bool isTurning = flight.ActiveTime < _turnsUntil && closing >= _slowest + ProgressMetresPerSecond;
        if (isNearer || isTurning)
            Note(flight, distance, closing);
        _slowest = Math.Min(_slowest, closing);
        TimeSpan limit = flight.Mission.SpeedMetresPerSecond > FastMetresPerSecond ? MaxTimeFast : MaxTimeSlow;
        return flight.ActiveTime - _since < limit ? MissionStep.Stay : React(flight);
    }

    private static (double Distance, double Closing) Approach(MissionFlight flight)
    {
        PlanePoint way = flight.GoalPosition - flight.Position;
        double climb = flight.GoalHeightMetres - flight.HeightMetres;
        double distance = Math.Sqrt((way.Length * way.Length) + (climb * climb));
        NedVector v = flight.Vehicle.VelocityNed;
        double closing = ((way.North * v.North) + (way.East * v.East) - (climb * v.Down)) / Math.Max(distance, 0.1);
        return (distance, closing);
    }

    private bool IsNewLeg(MissionFlight flight)
        => _to.DistanceTo(flight.GoalPosition) > 0 || !_height.Equals(HeightOf(flight));

    // A goal that follows the drift of the barometer is the same one.
    private static double HeightOf(MissionFlight flight) => flight.GoalHeightMetres - flight.HeightOffsetMetres;

    private void Begin(MissionFlight flight, double distance, double closing)
    {
        if (IsNewLeg(flight))
            _wasCommandedAgain = false;
        (_to, _height, _isWatching) = (flight.GoalPosition, HeightOf(flight), true);
        _turnsUntil = flight.ActiveTime + TimeSpan.OfSeconds(
            (flight.GroundSpeed + flight.Mission.SpeedMetresPerSecond) / BrakingMetresPerSecondSquared);
        Note(flight, distance, closing);
    }

    private void Note(MissionFlight flight, double distance, double closing)
        => (_since, _least, _slowest) = (flight.ActiveTime, distance, closing);

    private MissionStep React(MissionFlight flight)
    {
        _isWatching = false;
        const string What = "no progress along the leg";
        if (_wasCommandedAgain)
            return new MissionStep(MissionEvent.Hold, What);
        _wasCommandedAgain = true;
        flight.Log(What + ": commanded again");
        flight.Commands.Resend();
        return MissionStep.Stay;
    }
}
