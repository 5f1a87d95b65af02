namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// Brown-Conrady distortion with the rational radial part, as OpenCV defines it ("Camera Calibration and 3D
/// Reconstruction"): x and y at a distance of 1 along the optical axis.
/// </summary>
internal static class BrownConradyLens
{
    // Newton's method doubles the digits in each step: a lens that it cannot undo in so many is folded there.
    private const int MaxSteps = 30;

    // The step from there on leaves nothing that a double shows.
    private const double LastStepSquared = 1e-16;

    /// <summary>Undoes the distortion; false beyond the fold of the lens.</summary>
    public static bool TryUndistort(
        CameraModel lens, double distortedX, double distortedY, out double x, out double y)
    {
        (x, y) = (distortedX, distortedY);
        for (int step = 0; step < MaxSteps; step++)
        {
            Distort(lens, x, y, out Distorted at);
            double missX = distortedX - at.X;
            double missY = distortedY - at.Y;
            double determinant = (at.XByX * at.YByY) - (at.XByY * at.XByY);
            if (!(determinant > 0))
                return false;
            x += ((at.YByY * missX) - (at.XByY * missY)) / determinant;
            y += ((at.XByX * missY) - (at.XByY * missX)) / determinant;
            if ((missX * missX) + (missY * missY) < LastStepSquared)
                return true;
        }

        return false;
    }

    /// <summary>
    /// Distorts a direction; false where the lens folds: there, and beyond, another direction gives the same place.
    /// </summary>
    public static bool TryDistort(CameraModel lens, double x, double y, out double distortedX, out double distortedY)
    {
        Distort(lens, x, y, out Distorted at);
        (distortedX, distortedY) = (at.X, at.Y);
        if (!TryUndistort(lens, at.X, at.Y, out double backX, out double backY))
            return false;
        double tolerance = 1e-6 * (1 + (x * x) + (y * y));
        double missX = backX - x;
        double missY = backY - y;
        return (missX * missX) + (missY * missY) < tolerance * tolerance;
    }

    // With the derivatives; the mixed ones are equal.
    private static void Distort(CameraModel lens, double x, double y, out Distorted at)
    {
        double r2 = (x * x) + (y * y);
        double above = 1 + (r2 * (lens.K1 + (r2 * (lens.K2 + (r2 * lens.K3)))));
        double aboveByR2 = lens.K1 + (r2 * ((2 * lens.K2) + (3 * lens.K3 * r2)));
        double below = 1 + (r2 * (lens.K4 + (r2 * (lens.K5 + (r2 * lens.K6)))));
        double belowByR2 = lens.K4 + (r2 * ((2 * lens.K5) + (3 * lens.K6 * r2)));
        double gain = above / below;
        double gainByR2 = (aboveByR2 - (gain * belowByR2)) / below;
        at.X = (x * gain) + (2 * lens.P1 * x * y) + (lens.P2 * (r2 + (2 * x * x)));
        at.Y = (y * gain) + (lens.P1 * (r2 + (2 * y * y))) + (2 * lens.P2 * x * y);
        (at.XByX, at.XByY, at.YByY) = (0, 0, 0);

        // Turned inside out, about the centre or by the pole of the rational model: no derivative goes on from there.
        if (!(gain > 0 && below > 0))
            return;
        at.XByX = gain + (2 * x * x * gainByR2) + (2 * lens.P1 * y) + (6 * lens.P2 * x);
        at.XByY = (2 * x * y * gainByR2) + (2 * lens.P1 * x) + (2 * lens.P2 * y);
        at.YByY = gain + (2 * y * y * gainByR2) + (6 * lens.P1 * y) + (2 * lens.P2 * x);
    }

    private struct Distorted
    {
        public double X;
        public double Y;
        public double XByX;
        public double XByY;
        public double YByY;
    }
}
