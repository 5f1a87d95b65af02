using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// SET_POSITION_TARGET_GLOBAL_INT and _LOCAL_NED: silently ignored outside GUIDED; a combination of fields that
/// ArduCopter does not fly stops the vehicle. Targets of acceleration alone are not simulated and stop it too.
/// </summary>
internal sealed class TargetReader(FlightController controller, TelemetrySender telemetry, WorldFrame frame)
{
    private const double RadiansPerDegE7 = NedMath.RadiansPerDegree * 1e-7;
    private const int NorthPoleDegE7 = 900_000_000;
    private const int DateLineDegE7 = 1_800_000_000;

    private const PositionTargetTypemask NoPosition = PositionTargetTypemask.XIgnore | PositionTargetTypemask.YIgnore
        | PositionTargetTypemask.ZIgnore;
    private const PositionTargetTypemask NoVelocity = PositionTargetTypemask.VxIgnore | PositionTargetTypemask.VyIgnore
        | PositionTargetTypemask.VzIgnore;

    public void Handle(in SetPositionTargetGlobalInt message)
    {
        if (!controller.IsGuided)
            return;
        bool hasPosition = (message.TypeMask & NoPosition) == 0;
        NedVector place = default;
        if (hasPosition
            && !TryReadPlace(message.CoordinateFrame, message.LatInt, message.LonInt, message.Alt, out place))
        {
            controller.Guided.Stop(controller.Situation);
            return;
        }

        var velocity = new NedVector(message.Vx, message.Vy, message.Vz);
        Fly(
            message.TypeMask, place, velocity,
            ReadHeading(message.TypeMask, message.Yaw, message.YawRate, isFromNose: false));
    }

    public void Handle(in SetPositionTargetLocalNed message)
    {
        if (!controller.IsGuided)
            return;
        MavFrame axes = message.CoordinateFrame;
        if (axes is not (MavFrame.LocalNed or MavFrame.LocalOffsetNed or MavFrame.BodyNed or MavFrame.BodyOffsetNed)
            || telemetry.Origin is not { } origin)
        {
            controller.Guided.Stop(controller.Situation);
            return;
        }

        bool isBody = axes is MavFrame.BodyNed or MavFrame.BodyOffsetNed;
        bool isOffset = axes is MavFrame.LocalOffsetNed or MavFrame.BodyOffsetNed;
        NedVector place = ToWorldAxes(new NedVector(message.X, message.Y, message.Z), isBody)
            .Plus(isBody || isOffset ? controller.Situation.Position : origin);
        NedVector velocity = ToWorldAxes(new NedVector(message.Vx, message.Vy, message.Vz), isBody);
        Fly(
            message.TypeMask, place, velocity,
            ReadHeading(message.TypeMask, message.Yaw, message.YawRate, isFromNose: isBody));
    }

    /// <summary>A place in the frames of global positions; false where it is none.</summary>
    public bool TryReadPlace(MavFrame axes, int latitudeDegE7, int longitudeDegE7, float altitude, out NedVector place)
    {
        place = default;
        bool isPlace = latitudeDegE7 is >= -NorthPoleDegE7 and <= NorthPoleDegE7
            && longitudeDegE7 is >= -DateLineDegE7 and <= DateLineDegE7
            && (latitudeDegE7 != 0 || longitudeDegE7 != 0) && Math.Abs(altitude) < 1e5f;
        if (!isPlace || telemetry.Home is not { } home)
            return false;

        bool isAboveSea = axes is MavFrame.Global or MavFrame.GlobalInt;
        bool isAboveHome = axes is MavFrame.GlobalRelativeAlt or MavFrame.GlobalRelativeAltInt
            or MavFrame.GlobalTerrainAlt or MavFrame.GlobalTerrainAltInt;
        if (!isAboveSea && !isAboveHome)
            return false;
        double aboveSea = isAboveSea ? altitude : frame.Origin.AltitudeAmslMetres - home.Down + altitude;
        NedVector there = frame.ToWorld(
            GeodeticPosition.FromRadians(latitudeDegE7 * RadiansPerDegE7, longitudeDegE7 * RadiansPerDegE7, aboveSea));

        // Heights are counted from home, wherever the earth has curved to.
        place = isAboveSea ? there : new NedVector(there.North, there.East, home.Down - altitude);
        return true;
    }

    private void Fly(PositionTargetTypemask mask, NedVector place, NedVector velocity, in HeadingTarget heading)
    {
        bool hasPosition = (mask & NoPosition) == 0;
        bool hasVelocity = (mask & NoVelocity) == 0;
        bool isSound = (mask & PositionTargetTypemask.ForceSet) == 0 && (!hasPosition || IsFinite(place))
            && (!hasVelocity || IsFinite(velocity));
        GuidedFlight guided = controller.Guided;
        if (!isSound || (!hasPosition && !hasVelocity))
            guided.Stop(controller.Situation);
        else if (hasPosition && !controller.Failsafes.Fence.Accepts(place))
            return;   // outside the fence: the target before it stays
        else if (hasPosition && hasVelocity)
            guided.GoToWithVelocity(controller.Situation, place, velocity, heading);
        else if (hasPosition)
            guided.GoTo(controller.Situation, place, heading);
        else
            guided.FlyVelocity(controller.Situation, velocity, heading);
    }

    private HeadingTarget ReadHeading(PositionTargetTypemask mask, float yaw, float yawRate, bool isFromNose)
    {
        bool hasYaw = (mask & PositionTargetTypemask.YawIgnore) == 0 && IsFinite(yaw);
        bool hasRate = (mask & PositionTargetTypemask.YawRateIgnore) == 0 && IsFinite(yawRate);
        return new HeadingTarget(
            hasYaw ? yaw + (isFromNose ? controller.Situation.Yaw : 0) : double.NaN, hasRate ? yawRate : double.NaN);
    }

    private NedVector ToWorldAxes(NedVector vector, bool isBody)
    {
        if (!isBody)
            return vector;
        (double sin, double cos) = (Trig.Sin(controller.Situation.Yaw), Trig.Cos(controller.Situation.Yaw));
        return new NedVector(
            (vector.North * cos) - (vector.East * sin), (vector.North * sin) + (vector.East * cos), vector.Down);
    }

    private static bool IsFinite(NedVector v) => IsFinite(v.North) && IsFinite(v.East) && IsFinite(v.Down);

    private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
}
