namespace Rabit.Vision;

/// <summary>
/// The calibrated lens of a camera, as DJI's XMP has it (DewarpData): the model of Brown and Conrady, as OpenCV's. Of
/// the picture as it was taken. Immutable.
/// </summary>
public sealed record PhotoLens
{
    /// <summary>Focal length in columns, pixels.</summary>
    public double FocalX { get; init; }

    /// <summary>Focal length in rows, pixels.</summary>
    public double FocalY { get; init; }

    /// <summary>How far the principal point is to the right of the middle of the picture, pixels.</summary>
    public double CentreOffsetX { get; init; }

    /// <summary>How far the principal point is below the middle of the picture, pixels.</summary>
    public double CentreOffsetY { get; init; }

    /// <summary>Radial, of r squared.</summary>
    public double K1 { get; init; }

    /// <summary>Radial, of r to the fourth.</summary>
    public double K2 { get; init; }

    /// <summary>Tangential.</summary>
    public double P1 { get; init; }

    /// <summary>Tangential.</summary>
    public double P2 { get; init; }

    /// <summary>Radial, of r to the sixth.</summary>
    public double K3 { get; init; }
}
