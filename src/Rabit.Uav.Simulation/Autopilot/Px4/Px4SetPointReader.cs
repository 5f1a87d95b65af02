using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// SET_POSITION_TARGET_GLOBAL_INT and _LOCAL_NED: taken in any mode, flown in OFFBOARD. Set-points of acceleration
/// alone and what is no number are not taken: they do not keep OFFBOARD alive.
/// </summary>
internal sealed class Px4SetPointReader(Px4Controller controller, Px4Telemetry telemetry, WorldFrame frame)
{
    private const double RadiansPerDegE7 = NedMath.RadiansPerDegree * 1e-7;

    public void Handle(in SetPositionTargetGlobalInt message)
    {
        NedVector position = NotSaid;
        bool hasPlace = Has(message.TypeMask, PositionTargetTypemask.XIgnore)
            && Has(message.TypeMask, PositionTargetTypemask.YIgnore);
        if (hasPlace
            && !TryReadPlace(message.CoordinateFrame, message.LatInt, message.LonInt, message.Alt, out position))
        {
            return;
        }

        Take(
            message.TypeMask, position, new NedVector(message.Vx, message.Vy, message.Vz), message.Yaw,
            message.YawRate);
    }

    public void Handle(in SetPositionTargetLocalNed message)
    {
        bool isBody = message.CoordinateFrame == MavFrame.BodyNed;
        if ((!isBody && message.CoordinateFrame != MavFrame.LocalNed) || telemetry.Origin is not { } origin)
            return;
        NedVector offset = Turned(new NedVector(message.X, message.Y, message.Z), isBody);
        NedVector position = offset.Plus(isBody ? controller.Situation.Position : origin);
        NedVector velocity = Turned(new NedVector(message.Vx, message.Vy, message.Vz), isBody);
        Take(
            message.TypeMask, position, velocity, message.Yaw + (isBody ? controller.Situation.Yaw : 0),
            message.YawRate);
    }

    /// <summary>A place in the frames of global positions; false where it is none.</summary>
    public bool TryReadPlace(MavFrame axes, int latitudeDegE7, int longitudeDegE7, double altitude, out NedVector place)
    {
        place = default;
        bool isRelative = axes is MavFrame.GlobalRelativeAlt or MavFrame.GlobalRelativeAltInt;
        bool isAboveSea = axes is MavFrame.Global or MavFrame.GlobalInt;
        if ((!isRelative && !isAboveSea) || double.IsNaN(altitude)
            || Math.Abs((long)latitudeDegE7) > 900_000_000 || Math.Abs((long)longitudeDegE7) > 1_800_000_000)
        {
            return false;
        }

        NedVector home = controller.Situation.Home ?? default;
        double aboveSea = isAboveSea ? altitude : frame.Origin.AltitudeAmslMetres - home.Down + altitude;
        NedVector there = frame.ToWorld(GeodeticPosition.FromRadians(
            latitudeDegE7 * RadiansPerDegE7, longitudeDegE7 * RadiansPerDegE7, aboveSea));
        place = new NedVector(there.North, there.East, frame.Origin.AltitudeAmslMetres - aboveSea);
        return true;
    }

    private void Take(PositionTargetTypemask mask, NedVector position, NedVector velocity, double yaw, double yawRate)
    {
        var setPoint = new Px4SetPoint
        {
            Position = new NedVector(
                Said(mask, PositionTargetTypemask.XIgnore, position.North),
                Said(mask, PositionTargetTypemask.YIgnore, position.East),
                Said(mask, PositionTargetTypemask.ZIgnore, position.Down)),
            Velocity = new NedVector(
                Said(mask, PositionTargetTypemask.VxIgnore, velocity.North),
                Said(mask, PositionTargetTypemask.VyIgnore, velocity.East),
                Said(mask, PositionTargetTypemask.VzIgnore, velocity.Down)),
            Yaw = Said(mask, PositionTargetTypemask.YawIgnore, yaw),
            YawRate = Said(mask, PositionTargetTypemask.YawRateIgnore, yawRate),
        };
        bool steers = setPoint.HasPosition || !double.IsNaN(setPoint.Velocity.North)
            || !double.IsNaN(setPoint.Velocity.Down);
        if (!steers || (mask & PositionTargetTypemask.ForceSet) != 0)
            return;
        controller.Offboard.Take(setPoint);
        controller.Checks.ReceiveSetPoint();
    }

    private static NedVector NotSaid => new(double.NaN, double.NaN, double.NaN);

    private static bool Has(PositionTargetTypemask mask, PositionTargetTypemask ignored) => (mask & ignored) == 0;

    private static double Said(PositionTargetTypemask mask, PositionTargetTypemask ignored, double value)
        => (mask & ignored) != 0 || double.IsInfinity(value) ? double.NaN : value;

    private NedVector Turned(NedVector vector, bool isBody)
    {
        if (!isBody)
            return vector;
        (double sin, double cos) = (Trig.Sin(controller.Situation.Yaw), Trig.Cos(controller.Situation.Yaw));
        return new NedVector(
            (vector.North * cos) - (vector.East * sin), (vector.North * sin) + (vector.East * cos), vector.Down);
    }
}
