using System.Collections.Immutable;
using Rabit.Geodesy;

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

    /// <summary>Altitude of the ground, taken as level, metres above mean sea level.</summary>
    public double GroundAltitudeAmslMetres { get; set; }

    /// <summary>The classes to search for; empty, the default, for all that Image Processing has.</summary>
    public ImmutableArray<TargetClassName> Classes { get; set; }
}
