using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Flies to the start of the first lane; a gimbal is pointed first.</summary>
internal sealed class InTransitState() : MissionState(MissionPhase.InTransit)
{
    // A take-off ends this much below its height at most (5 % of 120 m).
    private const double LowMetres = 7;
    private const double MinClimbRate = 0.7;

    // For others of the group above: who flies a lane has passed by then, and gives way from then on.
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(2);

    private readonly TransitPath _path = new();
    private bool _isCameraPointed;
    private TimeSpan _limit;
    private double _speed;
    private PlanePoint? _climbAt;
    private double _climbYaw;
    private bool _mayWait;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        flight.Changes.BeginLeg();
        if (by == MissionEvent.OperatorSkip)
            flight.SkipLane();
        _isCameraPointed = !flight.Mission.HasGimbal;
        if (!flight.IsFixedWing)
            flight.Route!.Reorder(flight.Position);
        _path.Begin(flight, flight.Route!.Current?.Start ?? flight.Position);
        double climb = HeightHere(flight) - flight.HeightMetres;
        _speed = flight.Mission.SpeedMetresPerSecond;
        _limit = PathFollower.TimeLimit(flight, _path.Length) + Seconds(Math.Max(0, climb) / MinClimbRate);

        // A mission that continues may have been left low: what lies in the way is flown over.
        _climbAt = climb > LowMetres ? flight.Position : null;
        _climbYaw = flight.Vehicle.Attitude.Yaw.Radians;
        _mayWait = _climbAt is not null;
    }

    /// <summary>To the next lane; while it climbs it waits.</summary>
    public override MissionStep LeaveLeg(MissionFlight flight, string why)
    {
        if (_climbAt is null)
            flight.LeaveLane(why);
        return MissionStep.Stay;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Commands.LastFailure);
        _limit += PathFollower.MoreTime(flight, ref _speed);
        if (inPhase > _limit)
            return ReturnToLaunch($"not at the area within {MissionNumbers.Seconds(_limit)}");
        if (!_isCameraPointed)
        {
            PointCamera(flight);
            return MissionStep.Stay;
        }

        if (flight.IsFixedWing)
            return new MissionStep(MissionEvent.AtArea, "to the circle before the first lane");
        if (_climbAt is { } at)
        {
            if (IsWaiting(flight, inPhase))
                flight.SetGoal(VehicleCommandKind.Hold, "hold", RetryAfter);
            else
                Climb(flight, at);
            return MissionStep.Stay;
        }

        if (flight.Route!.Current is not { } lane)
            return new MissionStep(MissionEvent.AtArea, "all lanes are flown");
        if (flight.Group?.NextFollow(flight) is { } follow)
            return new MissionStep(MissionEvent.TargetFound, follow);

        if (_path.To.DistanceTo(lane.Start) > 0)
            _path.Begin(flight, lane.Start);
        flight.SetGoalPosition(_path.Next(flight), flight.Mission.HeightMetres, lane.HeadingRadians);
        flight.Text = $"to the area: {MissionNumbers.Of(flight.Position.DistanceTo(lane.Start))} m to go";
        return PathFollower.HasArrived(flight, lane.Start, flight.Mission.HeightMetres)
            ? new MissionStep(MissionEvent.AtArea, "at the first lane")
            : MissionStep.Stay;
    }

    // In its layer a vehicle sees who stays below it, but not that it is about to climb; once it climbs it goes on.
    private bool IsWaiting(MissionFlight flight, TimeSpan inPhase)
    {
        if (!_mayWait)
            return false;
        if (inPhase <= MaxWait && flight.Group?.FindAbove(flight) is { } other)
        {
            flight.Text = $"climbing: waits for vehicle {MissionNumbers.Of(other)}, which is above";
            return true;
        }

        _limit += inPhase;
        return _mayWait = false;
    }

    private void Climb(MissionFlight flight, PlanePoint at)
    {
        double height = HeightHere(flight);
        flight.SetGoalPosition(at, flight.Mission.HeightMetres, _climbYaw);
        flight.Text = $"climbing: {MissionNumbers.Of(flight.HeightMetres)} of {MissionNumbers.Of(height)} m";
        if (flight.HeightMetres >= height - PathFollower.ArrivalMetres)
            _climbAt = null;
    }

    private static double HeightHere(MissionFlight flight)
        => flight.Plan!.HeightAboveHome(flight.Position, flight.Mission.HeightMetres) + flight.HeightOffsetMetres;

    private void PointCamera(MissionFlight flight)
    {
        var command = new VehicleCommand
        {
            Kind = VehicleCommandKind.PointCamera,
            CameraPitch = flight.Mission.CameraPitch,
            CameraYaw = flight.Mission.CameraYaw,
            GimbalFrame = flight.Options.GimbalFrame,
        };
        flight.Text = "pointing the camera";
        if (!flight.Commands.IsGoal(command))
            flight.Commands.SetGoal(command, "point the camera", TimeSpan.FromSeconds(1));
        _isCameraPointed = flight.Commands.IsAccepted;
    }
}
