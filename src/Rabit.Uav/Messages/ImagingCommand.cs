namespace Rabit.Uav.Messages;

/// <summary>What Mission Control wants of Image Processing. A plain value.</summary>
public struct ImagingCommand
{
    /// <summary>What to do with pictures.</summary>
    public ImagingMode Mode { get; set; }

    /// <summary>Camera pitch against the body, radians, up positive; -pi/2 looks straight down with the top of the picture forward.</summary>
    public double CameraPitchRadians { get; set; }

    /// <summary>Camera yaw against the body, radians, right positive.</summary>
    public double CameraYawRadians { get; set; }

    /// <summary>Height of the ground, which is taken for flat, metres above mean sea level.</summary>
    public double GroundAltitudeAmslMetres { get; set; }

    /// <summary>The colours that targets may have.</summary>
    public TargetColours Colours { get; set; }
}
