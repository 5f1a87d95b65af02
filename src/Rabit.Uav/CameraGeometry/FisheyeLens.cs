using System;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// The fisheye of Kannala and Brandt ("A Generic Camera Model and Calibration Method for Conventional, Wide-Angle, and
/// Fish-Eye Lenses", 2006) with four coefficients, as OpenCV's module fisheye has it: a direction at an angle theta
/// from the optical axis is theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8) focal lengths from the
/// principal point. x and y at a distance of 1 along the optical axis.
/// </summary>
internal static class FisheyeLens
{
    /// <summary>Directions further from the optical axis have no place at a distance of 1 that is of use.</summary>
    public const double MaxTheta = 89 * Math.PI / 180;

    private const int MaxSteps = 50;
    private const double Converged = 1e-14;

    /// <summary>Undoes the distortion; false outside the circle that the lens sees.</summary>
    public static bool TryUndistort(
        CameraModel lens, double distortedX, double distortedY, out double x, out double y)
    {
        double distorted = Math.Sqrt((distortedX * distortedX) + (distortedY * distortedY));
        (x, y) = (distortedX, distortedY);
        if (!TryTheta(lens, distorted, out double theta))
            return false;
        double scale = distorted > 0 ? Math.Tan(theta) / distorted : 1;
        (x, y) = (scale * distortedX, scale * distortedY);
        return true;
    }

    /// <summary>Distorts a direction; false beyond the fold of the lens and beside it.</summary>
    public static bool TryDistort(CameraModel lens, double x, double y, out double distortedX, out double distortedY)
    {
        double r = Math.Sqrt((x * x) + (y * y));
        double theta = Math.Atan(r);
        Distort(lens, theta, out double distorted, out _);
        double scale = r > 0 ? distorted / r : 1;
        (distortedX, distortedY) = (scale * x, scale * y);
        return TryTheta(lens, distorted, out double back) && Math.Abs(back - theta) < 1e-6;
    }

    // Newton's method within an interval that holds the root: the circle grows with the angle, until it folds.
    private static bool TryTheta(CameraModel lens, double distorted, out double theta)
    {
        theta = 0;
        double low = 0;
        double high = EndOf(lens);
        Distort(lens, high, out double largest, out _);
        if (!(distorted <= largest))
            return false;
        theta = Math.Min(distorted, high);
        for (int step = 0; step < MaxSteps; step++)
        {
            Distort(lens, theta, out double at, out double slope);
            double miss = distorted - at;
            if (Math.Abs(miss) < Converged)
                return true;
            (low, high) = miss > 0 ? (theta, high) : (low, theta);
            double next = theta + (miss / slope);
            theta = next > low && next < high ? next : (low + high) / 2;
        }

        return high - low < 1e-9;
    }

    // The angle up to which the circle grows: that of the fold, found on a degree, or the limit of all.
    private static double EndOf(CameraModel lens)
    {
        const double Step = MaxTheta / 89;
        double theta = 0;
        while (theta + Step <= MaxTheta + 1e-12)
        {
            Distort(lens, theta + Step, out _, out double slope);
            if (!(slope > 0))
                break;
            theta += Step;
        }

        return theta;
    }

    private static void Distort(CameraModel lens, double theta, out double distorted, out double slope)
    {
        double t2 = theta * theta;
        distorted = theta * (1 + (t2 * (lens.K1 + (t2 * (lens.K2 + (t2 * (lens.K3 + (t2 * lens.K4))))))));
        slope = 1 + (t2 * ((3 * lens.K1) + (t2 * ((5 * lens.K2) + (t2 * ((7 * lens.K3) + (t2 * 9 * lens.K4)))))));
    }
}
