using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Gives a tracker a frame by the update of its message, as Autopilot Interface does.</summary>
internal static class TrackerFrames
{
    public static VehicleEvents UpdateBy(this VehicleTracker tracker, in LinkFrame frame)
    {
        if (frame.Frame.TryDecode(out Heartbeat heartbeat))
            return tracker.Update(frame, heartbeat);
        if (frame.Frame.TryDecode(out GlobalPositionInt position))
            return tracker.Update(frame, position);
        if (frame.Frame.TryDecode(out Attitude attitude))
            return tracker.Update(frame, attitude);
        if (frame.Frame.TryDecode(out SysStatus status))
            return tracker.Update(frame, status);
        if (frame.Frame.TryDecode(out BatteryStatus battery))
            return tracker.Update(frame, battery);
        if (frame.Frame.TryDecode(out GpsRawInt gps))
            return tracker.Update(frame, gps);
        if (frame.Frame.TryDecode(out SystemTime clock))
            return tracker.Update(frame, clock);
        if (frame.Frame.TryDecode(out ExtendedSysState extended))
            return tracker.Update(frame, extended);
        if (frame.Frame.TryDecode(out WindCov windCov))
            return tracker.Update(frame, windCov);
        if (frame.Frame.TryDecode(out EkfStatusReport ekf))
            return tracker.Update(frame, ekf);
        if (frame.Frame.TryDecode(out EstimatorStatus estimator))
            return tracker.Update(frame, estimator);
        return frame.Frame.TryDecode(out Wind wind) ? tracker.Update(frame, wind) : tracker.Update(frame);
    }
}
