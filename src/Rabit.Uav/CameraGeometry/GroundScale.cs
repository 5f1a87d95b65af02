using System;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// How far one pixel reaches on the ground at a place of the picture, metres for a pixel. A plain value.
/// </summary>
public struct GroundScale
{
    /// <summary>Metres north per column to the right.</summary>
    public double NorthByColumn { get; set; }

    /// <summary>Metres north per row down.</summary>
    public double NorthByRow { get; set; }

    /// <summary>Metres east per column to the right.</summary>
    public double EastByColumn { get; set; }

    /// <summary>Metres east per row down.</summary>
    public double EastByRow { get; set; }

    /// <summary>Square metres that a pixel covers.</summary>
    public readonly double PixelArea => Math.Abs((NorthByColumn * EastByRow) - (NorthByRow * EastByColumn));
}
