using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Tool.Geolocation;

/// <summary>A pixel that was asked for, and its place or why there is none.</summary>
internal sealed class LocatedPixel(double column, double row, GeolocationResult result, bool isTimed)
{
    public double Column => column;

    public double Row => row;

    public GeolocationResult Result => result;

    /// <summary>Whether its time and its pose are of a record; else one pose was given, or the photo's.</summary>
    public bool IsTimed => isTimed;

    /// <summary>Whether there is a place.</summary>
    public bool IsLocated => result.Error == GeolocationError.None;
}
