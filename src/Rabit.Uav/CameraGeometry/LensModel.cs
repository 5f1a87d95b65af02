namespace Rabit.Uav.CameraGeometry;

/// <summary>By which formula a lens bends rays.</summary>
public enum LensModel
{
    /// <summary>
    /// A pinhole with Brown-Conrady distortion: radial k1, k2, k3 over k4, k5, k6 (the rational model where those are
    /// not zero) and tangential p1, p2.
    /// </summary>
    BrownConrady,

    /// <summary>
    /// A fisheye (Kannala-Brandt, equidistant with k1 to k4): the distance from the principal point goes with the
    /// angle from the optical axis. Pixels that look 89 degrees or more from the axis are not used.
    /// </summary>
    Fisheye,
}
