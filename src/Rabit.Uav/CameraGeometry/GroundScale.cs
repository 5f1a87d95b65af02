using System;

namespace Rabit.Uav.CameraGeometry;

/// <summary>How far one pixel reaches on the ground at a place of the picture, metres for a pixel. A plain value.</summary>
internal struct GroundScale
{
    public double NorthByColumn { get; set; }

    public double NorthByRow { get; set; }

    public double EastByColumn { get; set; }

    public double EastByRow { get; set; }

    /// <summary>Square metres that a pixel covers.</summary>
    public readonly double PixelArea => Math.Abs((NorthByColumn * EastByRow) - (NorthByRow * EastByColumn));
}
