using System.Runtime.InteropServices;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>Judges the pictures of a camera, of light or thermal. No allocation; for one thread.</summary>
internal sealed class FrameJudge
{
    private readonly PictureJudge _colour = new();
    private readonly ThermalJudge _thermal = new();

    /// <summary>What was measured of the last picture that was looked at.</summary>
    public PictureFacts? Facts { get; private set; }

    /// <summary>Judges a picture, and measures it where it is not too coarse.</summary>
    public PictureQuality Judge(in CameraFrame frame, in PictureView view)
    {
        bool isThermal = frame.Format == PixelFormat.Grey16;
        PictureQuality quality = isThermal
            ? _thermal.Judge(MemoryMarshal.Cast<byte, ushort>(frame.Pixels.Array), frame.Width, frame.Height, view)
            : _colour.Judge(frame.Pixels.Array, frame.Width, frame.Height, view);
        if (quality != PictureQuality.TooCoarse)
            Facts = isThermal ? _thermal.Describe(frame.Exposure) : _colour.Describe(frame.Exposure);
        return quality;
    }

    /// <summary>Says how many targets were found in it.</summary>
    public void SetDetections(int count) => Facts = Facts!.Value with { Detections = count };
}
