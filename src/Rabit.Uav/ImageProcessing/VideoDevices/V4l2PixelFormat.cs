namespace Rabit.Uav.ImageProcessing;

/// <summary>What a <see cref="V4l2Camera"/> asks its device for.</summary>
public enum V4l2PixelFormat
{
    /// <summary>JPEG pictures (V4L2_PIX_FMT_MJPEG): what USB cameras give at larger sizes.</summary>
    Mjpeg,

    /// <summary>Raw YUV 4:2:2 (V4L2_PIX_FMT_YUYV): what they give at smaller ones, without artefacts.</summary>
    Yuyv,
}
