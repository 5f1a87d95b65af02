using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Has a gimbal point elsewhere than the mission says as long as that is asked for in every tick, and then as the
/// mission says again, until the autopilot has accepted it. Its commands stand beside the goal of the vehicle and give
/// way to it. One thread.
/// </summary>
internal sealed class CameraDirector(MissionFlight flight)
{
    // A smaller turn is not worth a command: the picture is tens of degrees wide.
    private const double MinTurnRadians = 1 * Angle.RadiansPerDegree;

    // Pictures are refused of a gimbal that is silent for that long.
    private static readonly TimeSpan MaxReportAge = TimeSpan.OfSeconds(1.5);

    private static readonly TimeSpan RetryAfter = TimeSpan.FromSeconds(1);

    private (Angle Pitch, Angle Yaw)? _asked;
    private VehicleCommand _sent;
    private long? _id;
    private TimeSpan _sentTime;
    private bool _isElsewhere;
    private bool _isAccepted;
    private bool _isRefused;

    /// <summary>
    /// Whether the mission has a gimbal to point, and it reports where it points: what it was commanded to is not where
    /// it is while it turns, and a target would be put at a wrong place.
    /// </summary>
    public bool IsThere => flight.Mission.HasGimbal && flight.Vehicle.GimbalTime is { } time
        && flight.Now - time <= MaxReportAge;

    /// <summary>Asks for a direction, in the frame of the mission's gimbal, for this tick.</summary>
    /// <param name="pitchRadians">Up positive.</param>
    /// <param name="yawRadians">Right positive.</param>
    public void Point(double pitchRadians, double yawRadians)
    {
        if (IsThere)
            _asked = (Angle.FromRadians(pitchRadians), Angle.FromRadians(yawRadians));
    }

    /// <summary>Sends what is due. At the end of a tick in which the vehicle can be commanded.</summary>
    public void Send()
    {
        (Angle Pitch, Angle Yaw)? asked = _asked;
        _asked = null;
        if (asked is null && !_isElsewhere)
            return;
        (Angle pitch, Angle yaw) = asked ?? (flight.Mission.CameraPitch, flight.Mission.CameraYaw);
        bool isDue = Turn(pitch, _sent.CameraPitch) >= MinTurnRadians || Turn(yaw, _sent.CameraYaw) >= MinTurnRadians
            || !_isElsewhere || !_isAccepted;
        bool isWaiting = (_isRefused || !IsNew(pitch, yaw)) && flight.Now - _sentTime < RetryAfter;
        if (asked is null && _isAccepted && !IsNew(pitch, yaw))
            _isElsewhere = false;
        else if (isDue && !isWaiting)
            Send(pitch, yaw);
    }

    /// <summary>Applies a result; those of other commands are ignored.</summary>
    public void Apply(in VehicleCommandResult result)
    {
        if (result.Id != _id)
            return;
        _isAccepted = result.Outcome == VehicleCommandOutcome.Accepted;
        bool isRefused = result.Outcome is VehicleCommandOutcome.Refused or VehicleCommandOutcome.TimedOut;
        if (isRefused && !_isRefused)
            flight.Log($"the camera is not pointed: {result.Outcome}, {result.Text}");
        _isRefused = isRefused;
    }

    private bool IsNew(Angle pitch, Angle yaw)
        => !_sent.CameraPitch.Equals(pitch) || !_sent.CameraYaw.Equals(yaw) || _id is null;

    private void Send(Angle pitch, Angle yaw)
    {
        var command = new VehicleCommand
        {
            Kind = VehicleCommandKind.PointCamera,
            CameraPitch = pitch,
            CameraYaw = yaw,
            GimbalFrame = flight.Options.GimbalFrame,
        };
        if (flight.Commands.SendBeside(command) is not { } id)
            return;
        (_id, _sent, _sentTime, _isAccepted, _isElsewhere) = (id, command, flight.Now, false, true);
    }

    private static double Turn(Angle to, Angle from)
        => Math.Abs(Math.IEEERemainder(to.Radians - from.Radians, 2 * Math.PI));
}
