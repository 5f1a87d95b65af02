using System;

namespace Rabit.Vision;

/// <summary>
/// Where a marker is, and how it is turned, in the axes of the camera: x to the right, y down, z along the optical
/// axis.
/// The marker's own axes are the same when it is seen upright and straight from the front. A plain value.
/// </summary>
public struct MarkerPose
{
    /// <summary>Centre of the marker, to the right of the camera, metres.</summary>
    public double X { get; set; }

    /// <summary>Centre of the marker, down from the camera, metres.</summary>
    public double Y { get; set; }

    /// <summary>Centre of the marker, along the optical axis, metres.</summary>
    public double Z { get; set; }

    /// <summary>The rotation from the marker to the camera as a unit quaternion: its scalar part, 0 or more.</summary>
    public double RotationW { get; set; }

    /// <summary>The rotation, first component of the vector part.</summary>
    public double RotationX { get; set; }

    /// <summary>The rotation, second component of the vector part.</summary>
    public double RotationY { get; set; }

    /// <summary>The rotation, third component of the vector part.</summary>
    public double RotationZ { get; set; }

    /// <summary>
    /// Sum of the squares of how far the corners lie from where this pose would show them, in sigmas of a coordinate:
    /// 8 coordinates less 6 numbers of the pose leave 2 in the mean.
    /// </summary>
    public double ChiSquare { get; set; }

    /// <summary>Standard deviation of <see cref="X"/>, metres.</summary>
    public double SigmaX { get; set; }

    /// <summary>Standard deviation of <see cref="Y"/>, metres.</summary>
    public double SigmaY { get; set; }

    /// <summary>Standard deviation of <see cref="Z"/>, metres.</summary>
    public double SigmaZ { get; set; }

    /// <summary>Standard deviation of the direction of the marker's normal, the larger of two, radians.</summary>
    public double SigmaTilt { get; set; }

    /// <summary>Distance from the camera to the centre, metres.</summary>
    public readonly double Distance => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));
}
