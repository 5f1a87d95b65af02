using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>A target that the detector found in one picture, and where it is. A plain value.</summary>
public struct TargetReport
{
    /// <summary>MAVLink system id of the vehicle that saw it.</summary>
    public byte SourceSystemId { get; set; }

    /// <summary>
    /// The picture it was seen in: <see cref="CameraObservation.Number"/>. With the source and <see cref="Index"/> it
    /// is the identity of the report.
    /// </summary>
    public long PictureNumber { get; set; }

    /// <summary>Which report of that picture it is, from 0.</summary>
    public int Index { get; set; }

    /// <summary>
    /// When it was there: mid-exposure by the clock of the run; of its own row, where rows are exposed one after the
    /// other.
    /// </summary>
    public TimeSpan Time { get; set; }

    /// <summary>Where it stood, on the ground.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>
    /// How uncertain that is, without what is the same in every picture of a flight (see
    /// <see cref="SystematicCovariance"/>).
    /// </summary>
    public HorizontalCovariance Covariance { get; set; }

    /// <summary>
    /// The part of the uncertainty that does not average out over the pictures of one vehicle: satellite position and
    /// mount biases.
    /// </summary>
    public HorizontalCovariance SystematicCovariance { get; set; }

    /// <summary>How the place moves for errors that stay the same; null where another vehicle saw it.</summary>
    internal TargetSensitivity? Sensitivity { get; set; }

    /// <summary>Its class: a declared one, or that of another vehicle.</summary>
    public TargetClassName Class { get; set; }

    /// <summary>
    /// The id of the printed marker that it is, 0 to 65534; null for what is none.
    /// </summary>
    public int? MarkerId { get; set; }

    /// <summary>How confident the detector is, 0 to 1.</summary>
    public double Score { get; set; }

    /// <summary>Side of a square of its area, metres.</summary>
    public double SizeMetres { get; set; }

    /// <summary>
    /// Where it pointed on the ground, clockwise from true north, by the pose at the time of its row; null where that
    /// was not measured, as of a square that is too small or of what is round, and where another vehicle saw it.
    /// </summary>
    public TargetBearing? Bearing { get; set; }

    /// <summary>Centre in the picture, column, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Centre in the picture, row, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>Width of the box around it in the picture, pixels; 0 where another vehicle saw it.</summary>
    public double WidthPixels { get; set; }

    /// <summary>Height of that box, pixels.</summary>
    public double HeightPixels { get; set; }
}
