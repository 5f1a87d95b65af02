using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

// Where it flies to. What a mode does not steer by is NaN and marked in the mask, as recorded.
internal sealed partial class Px4Telemetry
{
    private const PositionTargetTypemask NoPosition = PositionTargetTypemask.XIgnore | PositionTargetTypemask.YIgnore
        | PositionTargetTypemask.ZIgnore;
    private const PositionTargetTypemask Nothing = NoPosition | PositionTargetTypemask.VxIgnore
        | PositionTargetTypemask.VyIgnore | PositionTargetTypemask.VzIgnore;

    // Only the AUTO modes have one: in OFFBOARD and POSCTL it is silent, which shows that OFFBOARD is over before the
    // next heartbeat does.
    private bool TrySendGlobalTarget(int link)
    {
        if (controller.Target is not { } target)
            return false;
        GeodeticPosition place = frame.ToPlace(target);
        NedVector velocity = controller.Command.Velocity;
        return Send(link, new PositionTargetGlobalInt
        {
            TimeBootMs = BootMilliseconds,
            CoordinateFrame = MavFrame.GlobalInt,
            LatInt = DegE7(place.Latitude.Radians),
            LonInt = DegE7(place.Longitude.Radians),
            Alt = (float)place.AltitudeAmslMetres,
            Vx = (float)velocity.North,
            Vy = (float)velocity.East,
            Vz = (float)velocity.Down,
            Yaw = (float)_state.Attitude.Yaw.Radians,
        });
    }

    private void SendLocalTarget(int link)
    {
        NedVector? place = controller.LocalTarget;
        bool flies = controller.IsArmed && !controller.Situation.IsLanded;
        NedVector velocity = flies ? controller.Command.Velocity : NotKnown;
        NedVector local = place is { } target ? target.Minus(Origin ?? default) : NotKnown;
        sink.Send(link, new PositionTargetLocalNed
        {
            TimeBootMs = BootMilliseconds,
            CoordinateFrame = MavFrame.LocalNed,
            TypeMask = !flies ? Nothing : place is null ? NoPosition : 0,
            X = (float)local.North,
            Y = (float)local.East,
            Z = (float)local.Down,
            Vx = (float)velocity.North,
            Vy = (float)velocity.East,
            Vz = (float)velocity.Down,
            Yaw = (float)_state.Attitude.Yaw.Radians,
        });
    }

    private static NedVector NotKnown => new(double.NaN, double.NaN, double.NaN);
}
