using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

// What is reported of targets, the estimator and the fence.
internal sealed partial class TelemetrySender
{
    private const PositionTargetTypemask NoPlace = PositionTargetTypemask.XIgnore | PositionTargetTypemask.YIgnore
        | PositionTargetTypemask.ZIgnore;
    private const PositionTargetTypemask NoVelocity = PositionTargetTypemask.VxIgnore
        | PositionTargetTypemask.VyIgnore | PositionTargetTypemask.VzIgnore;
    private const PositionTargetTypemask NoAcceleration = PositionTargetTypemask.AxIgnore
        | PositionTargetTypemask.AyIgnore | PositionTargetTypemask.AzIgnore;
    private const PositionTargetTypemask NoYaw = PositionTargetTypemask.YawIgnore
        | PositionTargetTypemask.YawRateIgnore;

    // What the recorded ArduCopter has in POSITION_TARGET_GLOBAL_INT: all but the position, and unused bits.
    private const PositionTargetTypemask GlobalTargetMask = (PositionTargetTypemask)0xFDF8;

    // Only in GUIDED.
    private void SendLocalTarget()
    {
        if (!controller.IsGuided || Origin is not { } origin)
            return;
        (NedVector? place, NedVector? velocity) = controller.Guided.Target;
        NedVector local = place is { } target ? Offset(origin, target) : default;
        NedVector speed = velocity ?? default;
        PositionTargetTypemask mask = NoYaw | (place is null ? NoPlace : 0)
            | (velocity is null ? NoVelocity | NoAcceleration : 0);
        sink.Send(new PositionTargetLocalNed
        {
            TimeBootMs = BootMilliseconds,
            CoordinateFrame = MavFrame.LocalNed,
            TypeMask = mask,
            X = (float)local.North,
            Y = (float)local.East,
            Z = (float)local.Down,
            Vx = (float)speed.North,
            Vy = (float)speed.East,
            Vz = (float)speed.Down,
        });
    }

    // ArduPilot takes 1e-7 degrees for this many metres, of longitude times the cosine of the mean latitude
    // (Location::get_distance_NE): up to 0.7 % more than the earth has.
    private NedVector Offset(NedVector origin, NedVector target)
    {
        const double MetresPerDegE7 = 0.011131884502145034;
        GeodeticPosition from = frame.ToPlace(origin);
        GeodeticPosition to = frame.ToPlace(target);
        double metresPerRadian = MetresPerDegE7 * 1e7 / NedMath.RadiansPerDegree;
        double middle = (from.Latitude.Radians + to.Latitude.Radians) / 2;
        return new NedVector(
            (to.Latitude.Radians - from.Latitude.Radians) * metresPerRadian,
            NedMath.Wrapped(to.Longitude.Radians - from.Longitude.Radians) * metresPerRadian * Trig.Cos(middle),
            from.AltitudeAmslMetres - to.AltitudeAmslMetres);
    }

    // In RTL, and in GUIDED with a place and no velocity. There the recorded ArduCopter divides the offset from its
    // origin by 100: the place is wrong, as it is sent.
    private void SendGlobalTarget()
    {
        if (Origin is not { } origin)
            return;
        NedVector? sent = controller.ReturnTarget;
        if (controller.IsGuided && controller.Guided.Target is { Place: { } target, Velocity: null })
            sent = origin.Plus(target.Minus(origin).Times(0.01));
        if (sent is not { } place)
            return;
        GeodeticPosition there = frame.ToPlace(place);
        sink.Send(new PositionTargetGlobalInt
        {
            TimeBootMs = BootMilliseconds,
            CoordinateFrame = MavFrame.Global,
            TypeMask = GlobalTargetMask,
            LatInt = DegE7(there.Latitude.Radians),
            LonInt = DegE7(there.Longitude.Radians),
            Alt = (float)there.AltitudeAmslMetres,
        });
    }

    private void SendFence()
    {
        FenceFailsafe fence = controller.Failsafes.Fence;
        if (!fence.IsEnabled)
            return;
        bool isBreached = fence.Breached != FenceKinds.None;
        double age = Math.Max(0, (controller.Situation.Time - fence.BreachTime).ExactMilliseconds);
        sink.Send(new FenceStatus
        {
            BreachStatus = isBreached ? (byte)1 : (byte)0,
            BreachCount = (ushort)fence.BreachCount,
            BreachType = !isBreached ? FenceBreach.None
                : (fence.Breached & FenceKinds.MaxHeight) != 0 ? FenceBreach.Maxalt : FenceBreach.Boundary,
            BreachTime = fence.BreachCount == 0 ? 0 : (uint)Math.Max(0, BootMilliseconds - age),
            BreachMitigation = FenceMitigate.None,
        });
    }

    private void SendEstimator()
    {
        EstimatorFailsafe estimator = controller.Failsafes.Estimator;
        float ratio = (float)_state.EstimatorRatio;
        sink.Send(new EkfStatusReport
        {
            Flags = estimator.FlagsOf(controller.HasOrigin),
            VelocityVariance = ratio,
            PosHorizVariance = ratio,
            PosVertVariance = ratio,
        });
    }

    private void SendPressure() => sink.Send(new ScaledPressure
    {
        TimeBootMs = BootMilliseconds,
        PressAbs = (float)StandardAtmosphere.PressureAt(frame.Origin.AltitudeAmslMetres - _state.TrueDown),
    });
}
