using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>One target that a detector found in a picture. A plain value.</summary>
public struct TargetDetection
{
    /// <summary>Its class: one of <see cref="DetectorInput.Classes"/>.</summary>
    public TargetClassName Class { get; set; }

    /// <summary>Column of its centre, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Row of its centre, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>Width of the upright box around it, pixels; above 0.</summary>
    public double WidthPixels { get; set; }

    /// <summary>Height of the upright box around it, pixels; above 0.</summary>
    public double HeightPixels { get; set; }

    /// <summary>
    /// Side of a square of its area on the ground, metres, where the detector measured it; 0, the default, to have it
    /// computed from the box and the ground scale at its centre.
    /// </summary>
    public double SideMetres { get; set; }

    /// <summary>The id of the printed marker that it is; null for what is none.</summary>
    public int? MarkerId { get; set; }

    /// <summary>
    /// Where it points on the ground, by <see cref="DetectorInput.GroundScale"/>, with what the picture makes uncertain
    /// of it. Null, the default, where it was not measured.
    /// </summary>
    public TargetBearing? Bearing { get; set; }

    /// <summary>How confident the detector is, 0 to 1.</summary>
    public double Score { get; set; }

    /// <summary>How uncertain the centre is; must be positive definite.</summary>
    public PixelCovariance Covariance { get; set; }

    /// <summary>
    /// Whether the border of the picture may cut a part of it off; the centre is then that of what is seen. Image
    /// Processing does not report such a one unless <see cref="ImageProcessingOptions.ReportsCutTargets"/>: it may be a
    /// part of anything that is larger, and the next pictures show it whole.
    /// </summary>
    public bool IsCut { get; set; }
}
