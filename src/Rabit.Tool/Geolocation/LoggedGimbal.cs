using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Tool.Geolocation;

/// <summary>What a log has of the attitude of a gimbal, as the Autopilot Interface takes it in flight.</summary>
internal sealed class LoggedGimbal
{
    private readonly GimbalTracker _tracker = new();
    private readonly List<(GimbalAttitude Attitude, uint BootTimeMs, TimeSpan Stamp)> _reports = [];

    /// <summary>Takes a frame of the vehicle; those that say nothing of a gimbal are left alone.</summary>
    public void Take(in LoggedFrame logged)
    {
        if (Update(logged) == GimbalUpdate.Taken)
            _reports.Add((_tracker.Attitude, logged.IsOfAutopilot ? _tracker.BootTimeMs : 0, logged.Stamp));
    }

    /// <summary>Adds them by the autopilot's clock.</summary>
    /// <param name="locator">Takes them.</param>
    /// <param name="stampsLessBoot">
    /// Of the log, for reports of a gimbal itself, whose clock is not known, and for those without a time.
    /// </param>
    public void AddTo(PixelGeolocator locator, TimeSpan stampsLessBoot)
    {
        foreach ((GimbalAttitude attitude, uint bootTimeMs, TimeSpan stamp) in _reports)
        {
            locator.Add(new PoseSample
            {
                Kind = PoseSampleKind.Gimbal,
                Time = bootTimeMs != 0 ? TimeSpan.FromMilliseconds(bootTimeMs) : stamp - stampsLessBoot,
                Gimbal = attitude,
            });
        }
    }

    private GimbalUpdate Update(in LoggedFrame logged)
    {
        MavlinkFrame mavlink = logged.Frame;
        var frame = new LinkFrame { Frame = mavlink, Time = logged.Stamp };
        if (mavlink.MessageId == GimbalDeviceAttitudeStatus.MavlinkId
            && mavlink.TryDecode(out GimbalDeviceAttitudeStatus status))
            return _tracker.Take(frame, status);
        return mavlink.MessageId == MountOrientation.MavlinkId && mavlink.TryDecode(out MountOrientation mount)
            ? _tracker.Take(frame, mount)
            : GimbalUpdate.OfOther;
    }
}
