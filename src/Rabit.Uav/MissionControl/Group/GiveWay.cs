using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Gives way to a vehicle of the group that would come too near: waits where it is, or flies away from it where it is
/// near already, until the way is clear. One thread.
/// </summary>
internal sealed class GiveWay(GroupSeparation separation, Action<string> log)
{
    // Away from the other one: more than has to be, for it drifts.
    private const double AwayMetres = GroupSeparation.HorizontalMetres + 15;

    private const double BrakingMetresPerSecondSquared = 1.5;

    // Directions that are tried, where away from the other one leads out of the fence.
    private const int Directions = 8;

    // A report that is missed must not end it.
    private static readonly TimeSpan MinClear = TimeSpan.FromSeconds(2);

    // Who lands has passed by then; who is held there stays.
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(30);

    private SeparationConflict? _conflict;
    private PlanePoint _wanted;
    private PlanePoint _at;
    private double _heightAboveGround;
    private double _yaw;
    private TimeSpan _since;
    private TimeSpan _lastConflict;

    /// <summary>Looks for others, and sets the goal while it gives way.</summary>
    /// <param name="flight">The state of the mission; with a plan, on a leg.</param>
    /// <param name="systemId">Ours.</param>
    /// <param name="own">What we report.</param>
    /// <returns>To which vehicle; null where the way is clear.</returns>
    public byte? Tick(MissionFlight flight, byte systemId, in GroupReport own)
    {
        PlanePoint wanted = VelocityTo(flight, _conflict is null ? flight.GoalPosition : _wanted);
        if (separation.FindConflict(flight, systemId, own, wanted) is { } found)
            Meet(flight, found);
        if (_conflict is not { } current)
            return null;
        if (flight.Now - _lastConflict >= MinClear)
        {
            End($"vehicle {MissionNumbers.Of(current.SystemId)} is out of the way");
            return null;
        }

        if (_at.DistanceTo(current.Place) < GroupSeparation.HorizontalMetres)
            _at = PlaceAwayFrom(flight, current.Place);
        flight.SetGoalPosition(_at, _heightAboveGround, _yaw);
        flight.Text = $"gives way to vehicle {MissionNumbers.Of(current.SystemId)}";
        return current.SystemId;
    }

    /// <summary>Whether what is in the way stays there: something else is to be done.</summary>
    public bool IsBlocked(TimeSpan now) => _conflict is not null && now - _since >= MaxWait;

    /// <summary>Ends it: something else is done.</summary>
    public void End(string? text = null)
    {
        if (_conflict is not null && text is not null)
            log(text);
        _conflict = null;
    }

    private void Meet(MissionFlight flight, in SeparationConflict found)
    {
        (bool isFirst, bool isSame) = (_conflict is null, _conflict?.SystemId == found.SystemId);
        (_conflict, _lastConflict) = (found, flight.Now);
        if (isSame)
            return;
        _since = flight.Now;
        if (isFirst)
            Stop(flight);
        string where = found.AboveMetres >= 0 ? "above" : "below";
        log($"gives way to vehicle {MissionNumbers.Of(found.SystemId)}: "
            + $"{MissionNumbers.Of(flight.Position.DistanceTo(found.Place))} m over ground from it, "
            + $"{MissionNumbers.Of(Math.Abs(found.AboveMetres))} m {where} us");
    }

    private void Stop(MissionFlight flight)
    {
        var velocity = new PlanePoint(flight.Vehicle.VelocityNed.North, flight.Vehicle.VelocityNed.East);
        _at = flight.Position + (velocity.Length / (2 * BrakingMetresPerSecondSquared) * velocity);
        _wanted = flight.GoalPosition;
        _heightAboveGround = flight.HeightAboveGroundMetres - flight.HeightOffsetMetres;
        _yaw = flight.Vehicle.Attitude.Yaw.Radians;
    }

    // As it goes on, or would: it is faster there than it is now, where it has just begun.
    private static PlanePoint VelocityTo(MissionFlight flight, PlanePoint goal)
    {
        PlanePoint way = goal - flight.Position;
        double speed = Math.Max(flight.Mission.SpeedMetresPerSecond, flight.GroundSpeed);
        return way.Length > PathFollower.ArrivalMetres ? speed / way.Length * way : default;
    }

    private static PlanePoint PlaceAwayFrom(MissionFlight flight, PlanePoint other)
    {
        PlanePoint away = flight.Position - other;
        double heading = away.Length > 0 ? away.HeadingRadians : (default(PlanePoint) - other).HeadingRadians;
        for (int i = 0; i < Directions; i++)
        {
            // Straight away first, then more and more to the one side and the other.
            double turn = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) * (2 * Math.PI / Directions);
            PlanePoint place = other + (AwayMetres * PlanePoint.Towards(heading + turn));
            if (flight.Plan!.InsideMetres(place) >= MissionPlanRules.FenceReserveMetres)
                return place;
        }

        return flight.Position;
    }
}
