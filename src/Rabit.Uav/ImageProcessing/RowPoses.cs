using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>When the rows of a picture were exposed, and the poses then. For one thread.</summary>
internal sealed class RowPoses(CameraModel camera, PoseHistory poses, TimeSpan maxExtrapolation)
{
    /// <summary>The middle of the exposure of a row, by the clock of the run.</summary>
    public TimeSpan TimeOf(in CameraFrame frame, double row) => frame.MidExposure + camera.ReadoutOf(row);

    /// <summary>The pose of a row. The caller has made sure that there are poses around all of them.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="row">From 0, the top one.</param>
    /// <param name="middle">At the middle of the exposure of the middle row.</param>
    public Pose PoseOf(in CameraFrame frame, double row, in Pose middle)
    {
        Pose pose = middle;
        TimeSpan time = TimeOf(frame, row);

        // Where poses are extrapolated, the last rows may lie a little beyond, and go on from the middle one.
        if (camera.Readout > TimeSpan.Zero
            && poses.Extrapolate(time, maxExtrapolation, out pose) is not (PoseLookup.Known or PoseLookup.Extrapolated))
        {
            pose = middle.After((time - middle.Time).ExactSeconds);
            pose.ExtrapolatedSeconds = Math.Max(0, middle.ExtrapolatedSeconds + (time - middle.Time).ExactSeconds);
        }

        return pose;
    }
}
