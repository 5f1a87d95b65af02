using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Flies to the start of the first lane; a gimbal is pointed first.</summary>
internal sealed class InTransitState() : MissionState(MissionPhase.InTransit)
{
    private bool _isCameraPointed;
    private TimeSpan _limit;

    public override void Enter(MissionFlight flight, MissionEvent by)
    {
        _isCameraPointed = !flight.Mission.HasGimbal;
        _limit = PathFollower.TimeLimit(flight, flight.Position.DistanceTo(flight.Route!.Current!.Value.Start));
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Commands.LastFailure);
        if (inPhase > _limit)
            return ReturnToLaunch($"not at the area within {MissionNumbers.Seconds(_limit)}");
        if (!_isCameraPointed)
        {
            PointCamera(flight);
            return MissionStep.Stay;
        }

        LaneSegment lane = flight.Route!.Current!.Value;
        flight.SetGoalPosition(lane.Start, flight.Mission.HeightMetres, lane.HeadingRadians);
        flight.Text = $"to the area: {MissionNumbers.Of(flight.Position.DistanceTo(lane.Start))} m to go";
        return PathFollower.HasArrived(flight, lane.Start, flight.Mission.HeightMetres)
            ? new MissionStep(MissionEvent.AtArea, "at the first lane")
            : MissionStep.Stay;
    }

    private void PointCamera(MissionFlight flight)
    {
        var command = new VehicleCommand
        {
            Kind = VehicleCommandKind.PointCamera,
            CameraPitch = flight.Mission.CameraPitch,
            CameraYaw = flight.Mission.CameraYaw,
        };
        flight.Text = "pointing the camera";
        if (!flight.Commands.IsGoal(command))
            flight.Commands.SetGoal(command, "point the camera", TimeSpan.FromSeconds(1));
        _isCameraPointed = flight.Commands.IsAccepted;
    }
}
