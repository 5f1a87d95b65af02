using System;

namespace Rabit.Vision;

/// <summary>
/// The pose of a marker from its four corners. A flat thing that is seen from afar has two that show it nearly alike,
/// mirrored at the line of sight: both are fitted and judged. Any thread.
/// </summary>
/// <remarks>
/// Schweighofer and Pinz, "Robust pose estimation from a planar target", IEEE PAMI 28(12), 2006; Collins and Bartoli,
/// "Infinitesimal plane-based pose estimation", IJCV 109, 2014.
/// </remarks>
/// <example>
/// A marker of 0.5 m, by a camera without distortion whose focal length is 900 pixels:
/// <code>
/// DetectedMarker marker = default;   // as MarkerDetector found it
/// var rays = new PicturePoint[4];
/// for (int i = 0; i &lt; 4; i++)
///     rays[i] = new PicturePoint((marker.Corners[i].X - 319.5) / 900, (marker.Corners[i].Y - 239.5) / 900);
/// if (MarkerPoseSolver.TrySolve(rays, 0.5, marker.CornerSigmaPixels / 900, out MarkerPose best, out MarkerPose other))
///     Console.WriteLine($"{best.Distance} m away; turned unclearly: {MarkerPoseSolver.IsAmbiguous(best, other)}");
/// </code>
/// </example>
public static class MarkerPoseSolver
{
    // What two poses must differ by in the sum of squares for the worse one to be refused: 95 % of one degree of
    // freedom and some more, since sigmas are estimates.
    private const double Clear = 6;

    /// <summary>Finds both poses; false if the corners are none of a square in front of the camera.</summary>
    /// <param name="rays">
    /// Where the four corners are, in the order of <see cref="MarkerCorners"/>, without lens distortion: to the right
    /// and down, for 1 along the optical axis.
    /// </param>
    /// <param name="sideMetres">Side of the black square.</param>
    /// <param name="sigma">
    /// How uncertain each coordinate is, one standard deviation: pixels by the focal length.
    /// </param>
    /// <param name="best">The pose that fits better.</param>
    /// <param name="other">The other one; the same where there is only one, as straight from the front.</param>
    /// <exception cref="ArgumentException">There are not four corners, or the side or sigma is not above 0.</exception>
    public static bool TrySolve(
        ReadOnlySpan<PicturePoint> rays, double sideMetres, double sigma, out MarkerPose best, out MarkerPose other)
    {
        if (rays.Length != 4)
            throw new ArgumentException($"A marker has 4 corners, not {rays.Length}.", nameof(rays));
        if (!(sideMetres > 0 && sideMetres <= double.MaxValue))
            throw new ArgumentException($"A marker's side is {sideMetres}; it must be above 0.", nameof(sideMetres));
        if (!(sigma > 0 && sigma <= double.MaxValue))
            throw new ArgumentException($"Sigma is {sigma}; it must be above 0.", nameof(sigma));
        (best, other) = (default, default);
        var quad = new MarkerCorners(rays[0], rays[1], rays[2], rays[3]);
        PlaneMap map = PlaneMap.ToQuad(quad);
        if (!(QuadFitter.Area(quad) > 0) || !map.IsInFront)
            return false;
        var first = new PoseFit(rays, sideMetres);
        first.Start(map);
        if (!first.Refine())
            return false;
        PoseFit second = first;
        second.Mirror();
        if (!second.Refine())
            second = first;
        best = first.ToPose(sigma);
        other = second.ToPose(sigma);
        if (other.ChiSquare < best.ChiSquare)
            (best, other) = (other, best);
        return true;
    }

    /// <summary>
    /// Whether both poses explain the corners: then the direction of the marker's normal is one of two, while its
    /// position is known all the same.
    /// </summary>
    /// <param name="best">The better one.</param>
    /// <param name="other">The other one.</param>
    public static bool IsAmbiguous(in MarkerPose best, in MarkerPose other)
        => other.ChiSquare - best.ChiSquare < Clear && AngleBetween(best, other) > 2 * best.SigmaTilt;

    private static double AngleBetween(in MarkerPose a, in MarkerPose b)
    {
        double dot = (a.RotationW * b.RotationW) + (a.RotationX * b.RotationX) + (a.RotationY * b.RotationY)
            + (a.RotationZ * b.RotationZ);
        return 2 * Math.Acos(Math.Min(1, Math.Abs(dot)));
    }
}
