using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Messages;

/// <summary>A command of Mission Control to Image Processing. A plain value.</summary>
public struct ImagingCommand
{
    /// <summary>What to do with pictures.</summary>
    public ImagingMode Mode { get; set; }

    /// <summary>
    /// Camera pitch, up positive, in <c>CameraMount.GimbalFrame</c>; -90 degrees points straight down with the top of
    /// the picture forward. Not used where the gimbal reports its attitude.
    /// </summary>
    public Angle CameraPitch { get; set; }

    /// <summary>Camera yaw, right positive, as the pitch.</summary>
    public Angle CameraYaw { get; set; }

    /// <summary>
    /// Camera roll, right side down positive, as the pitch; 0, the default, for a gimbal that holds the picture level.
    /// Mission Control commands none.
    /// </summary>
    public Angle CameraRoll { get; set; }

    /// <summary>Altitude of the ground, taken as level, metres above mean sea level.</summary>
    public double GroundAltitudeAmslMetres { get; set; }

    /// <summary>The classes to search for; empty, the default, for all that Image Processing has.</summary>
    public ImmutableArray<TargetClassName> Classes { get; set; }

    /// <summary>How the camera is pointed by it.</summary>
    internal readonly GimbalAttitude Pointing(GimbalFrame frame)
        => new(new EulerAngles(CameraRoll, CameraPitch, CameraYaw), frame);
}
