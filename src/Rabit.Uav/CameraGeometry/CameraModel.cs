using System;
using System.Collections.Generic;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// A camera's pinhole and its lens, as OpenCV defines them: camera axes x right, y down, z along the optical axis; the
/// centre of the top left pixel is (0, 0); Brown-Conrady distortion k1, k2, p1, p2, k3 (OpenCV, "Camera Calibration and
/// 3D Reconstruction"). Immutable.
/// </summary>
public sealed class CameraModel
{
    /// <summary>Columns of the picture.</summary>
    public int Width { get; init; }

    /// <summary>Rows of the picture.</summary>
    public int Height { get; init; }

    /// <summary>Focal length along columns, pixels.</summary>
    public double FocalX { get; init; }

    /// <summary>Focal length along rows, pixels.</summary>
    public double FocalY { get; init; }

    /// <summary>Principal point, column, pixels.</summary>
    public double CentreX { get; init; }

    /// <summary>Principal point, row, pixels.</summary>
    public double CentreY { get; init; }

    /// <summary>Radial distortion, second order.</summary>
    public double K1 { get; init; }

    /// <summary>Radial distortion, fourth order.</summary>
    public double K2 { get; init; }

    /// <summary>Tangential distortion.</summary>
    public double P1 { get; init; }

    /// <summary>Tangential distortion.</summary>
    public double P2 { get; init; }

    /// <summary>Radial distortion, sixth order.</summary>
    public double K3 { get; init; }

    /// <summary>How long after the row above it a row is exposed: the line time of a rolling shutter.</summary>
    /// <value>The default is zero: all rows at once.</value>
    public TimeSpan RowReadout { get; init; }

    // Newton's method doubles the digits in each step: a lens that it cannot undo in so many is folded there.
    private const int MaxSteps = 30;
    private const double ConvergedSquared = 1e-26;

    // No picture takes longer to read; it also is less than the poses around it may be apart.
    private static readonly TimeSpan MaxReadout = TimeSpan.FromMilliseconds(500);

    /// <summary>
    /// The direction in which a pixel looks, with the lens distortion undone: (x, y, 1) in the axes of the camera.
    /// False where it cannot be undone: outside the picture it may fold.
    /// </summary>
    /// <param name="column">Pixels; the centre of the top left pixel is 0.</param>
    /// <param name="row">Pixels; the centre of the top left pixel is 0.</param>
    /// <param name="x">To the right, for 1 along the optical axis.</param>
    /// <param name="y">Down, for 1 along the optical axis.</param>
    public bool TryUndistort(double column, double row, out double x, out double y)
    {
        double wantedX = (column - CentreX) / FocalX;
        double wantedY = (row - CentreY) / FocalY;
        (x, y) = (wantedX, wantedY);
        for (int step = 0; step < MaxSteps; step++)
        {
            Distort(x, y, out Distorted at);
            double missX = wantedX - at.X;
            double missY = wantedY - at.Y;
            double determinant = (at.XByX * at.YByY) - (at.XByY * at.XByY);
            if (!(determinant > 0))
                return false;
            if ((missX * missX) + (missY * missY) < ConvergedSquared)
                return true;
            x += ((at.YByY * missX) - (at.XByY * missY)) / determinant;
            y += ((at.XByX * missY) - (at.XByY * missX)) / determinant;
        }

        return false;
    }

    /// <summary>
    /// The pixel at which something is seen; false if it is not in front of the camera. It may lie outside the picture.
    /// </summary>
    /// <param name="x">To the right of the camera, in any unit.</param>
    /// <param name="y">Below it.</param>
    /// <param name="z">In front of it, along the optical axis.</param>
    /// <param name="column">Pixels; the centre of the top left pixel is 0.</param>
    /// <param name="row">Pixels; the centre of the top left pixel is 0.</param>
    public bool TryProject(double x, double y, double z, out double column, out double row)
    {
        if (!(z > 0))
        {
            (column, row) = (double.NaN, double.NaN);
            return false;
        }

        Distort(x / z, y / z, out Distorted at);
        (column, row) = ((FocalX * at.X) + CentreX, (FocalY * at.Y) + CentreY);
        return true;
    }

    /// <summary>How long after the top row's the middle of the exposure of a row is.</summary>
    internal TimeSpan ReadoutOf(double row) => TimeSpan.FromTicks((long)Math.Round(row * RowReadout.Ticks));

    /// <summary>What is wrong with it, one line each.</summary>
    internal IEnumerable<string> FindFaults()
    {
        if (RowReadout < TimeSpan.Zero || ReadoutOf(Height) > MaxReadout)
        {
            yield return FormattableString.Invariant(
                $"the camera's rows are {RowReadout.TotalMilliseconds} ms apart; that must not be negative, and all {Height} rows not take longer than {MaxReadout.TotalSeconds} s");
        }

        if (Width < 1 || Height < 1)
            yield return FormattableString.Invariant($"the camera's picture is {Width} x {Height}");
        if (!(FocalX > 0 && FocalY > 0) || double.IsInfinity(FocalX + FocalY))
            yield return FormattableString.Invariant(
                $"the camera's focal length is {FocalX}, {FocalY}; it must be above 0");
        double sum = CentreX + CentreY + K1 + K2 + P1 + P2 + K3;
        if (double.IsNaN(sum) || double.IsInfinity(sum))
            yield return "the camera's principal point or distortion is not a number";
        else if (Width > 0 && Height > 0 && FocalX > 0 && FocalY > 0 && !CanUndistortBorder())
            yield return "the camera's distortion cannot be undone over the whole picture";
    }

    private bool CanUndistortBorder()
    {
        for (int i = 0; i <= 8; i++)
        {
            double column = (Width - 1) * i / 8.0;
            double row = (Height - 1) * i / 8.0;
            if (!TryUndistort(column, 0, out _, out _) || !TryUndistort(column, Height - 1, out _, out _)
                || !TryUndistort(0, row, out _, out _) || !TryUndistort(Width - 1, row, out _, out _))
                return false;
        }

        return true;
    }

    // OpenCV, "Camera Calibration and 3D Reconstruction", with the derivatives; the mixed ones are equal.
    private void Distort(double x, double y, out Distorted at)
    {
        double r2 = (x * x) + (y * y);
        double gain = 1 + (r2 * (K1 + (r2 * (K2 + (r2 * K3)))));
        double gainByR2 = K1 + (r2 * ((2 * K2) + (3 * K3 * r2)));
        at.X = (x * gain) + (2 * P1 * x * y) + (P2 * (r2 + (2 * x * x)));
        at.Y = (y * gain) + (P1 * (r2 + (2 * y * y))) + (2 * P2 * x * y);
        at.XByX = gain + (2 * x * x * gainByR2) + (2 * P1 * y) + (6 * P2 * x);
        at.XByY = (2 * x * y * gainByR2) + (2 * P1 * x) + (2 * P2 * y);
        at.YByY = gain + (2 * y * y * gainByR2) + (6 * P1 * y) + (2 * P2 * x);
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
