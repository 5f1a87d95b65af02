using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The poses of pictures by one camera, whose rows may be exposed one after the other.</summary>
internal sealed class PicturePoses(CameraModel camera, PoseHistory poses)
{
    /// <summary>Mid-exposure of the middle row.</summary>
    public TimeSpan MiddleOf(in CameraFrame frame) => frame.MidExposure + TimeSpan.FromTicks(LastRow.Ticks / 2);

    /// <summary>The pose of the middle row, once the poses around the first and the last one are known too.</summary>
    public PoseLookup Find(in CameraFrame frame, out Pose pose)
    {
        PoseLookup answer = poses.Find(MiddleOf(frame), out pose);
        if (answer != PoseLookup.Known || LastRow == TimeSpan.Zero)
            return answer;
        PoseLookup first = poses.Find(frame.MidExposure, out _);
        return first == PoseLookup.Known ? poses.Find(frame.MidExposure + LastRow, out _) : first;
    }

    // How much later the last row is exposed than the first one.
    private TimeSpan LastRow => camera.ReadoutOf(camera.Height - 1);
}
