using System;
using System.Collections.Generic;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// A camera's intrinsics: its pinhole and its lens, as OpenCV defines them: camera axes x right, y down, z along the
/// optical axis; the centre of the top left pixel is (0, 0) ("Camera Calibration and 3D Reconstruction"; fisheyes:
/// module fisheye). Where only a data sheet is known, <see cref="FocalLength"/> computes the focal length. Immutable.
/// </summary>
/// <example>
/// <code>
/// double focal = FocalLength.FromFieldOfView(1640, Angle.FromDegrees(62.2));
/// var camera = new CameraModel
/// {
///     Width = 1640, Height = 1232, FocalX = focal, FocalY = focal, CentreX = 819.5, CentreY = 615.5,
///     FocalLengthError = 0.02,
/// };
/// </code>
/// </example>
public sealed class CameraModel
{
    /// <summary>Columns of the picture.</summary>
    public int Width { get; init; }

    /// <summary>Rows of the picture.</summary>
    public int Height { get; init; }

    /// <summary>
    /// How its pixels are arranged: <see cref="PixelFormat.Grey16"/> of a thermal camera, whose pictures are 16-bit PGM
    /// or grey PNG.
    /// </summary>
    /// <value>The default is <see cref="PixelFormat.Rgb24"/>.</value>
    public PixelFormat Format { get; init; }

    /// <summary>Focal length along columns, pixels.</summary>
    public double FocalX { get; init; }

    /// <summary>Focal length along rows, pixels.</summary>
    public double FocalY { get; init; }

    /// <summary>Principal point, column, pixels.</summary>
    public double CentreX { get; init; }

    /// <summary>Principal point, row, pixels.</summary>
    public double CentreY { get; init; }

    /// <summary>
    /// How wrong the focal length may be, as a part of it (one standard deviation): 0 where it was calibrated. It joins
    /// <c>ErrorBudget.FocalLengthBias</c>.
    /// </summary>
    public double FocalLengthError { get; init; }

    /// <summary>The formula of the lens.</summary>
    /// <value>The default is <see cref="LensModel.BrownConrady"/>.</value>
    public LensModel Lens { get; init; }

    /// <summary>Radial distortion, second order; of a fisheye, of the angle's third power.</summary>
    public double K1 { get; init; }

    /// <summary>Radial distortion, fourth order; of a fisheye, of the angle's fifth power.</summary>
    public double K2 { get; init; }

    /// <summary>Tangential distortion; 0 for a fisheye.</summary>
    public double P1 { get; init; }

    /// <summary>Tangential distortion; 0 for a fisheye.</summary>
    public double P2 { get; init; }

    /// <summary>Radial distortion, sixth order; of a fisheye, of the angle's seventh power.</summary>
    public double K3 { get; init; }

    /// <summary>
    /// Radial distortion of the rational model, second order below the line; of a fisheye, of the angle's ninth power.
    /// </summary>
    public double K4 { get; init; }

    /// <summary>Radial distortion of the rational model, fourth order below the line; 0 for a fisheye.</summary>
    public double K5 { get; init; }

    /// <summary>Radial distortion of the rational model, sixth order below the line; 0 for a fisheye.</summary>
    public double K6 { get; init; }

    /// <summary>
    /// How long the sensor reads a whole picture, all rows: a rolling shutter. Row r of <see cref="Height"/> rows is
    /// exposed r / Height of it after the top row.
    /// </summary>
    /// <value>The default is zero: all rows at once.</value>
    public TimeSpan Readout { get; init; }

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
        double distortedX = (column - CentreX) / FocalX;
        double distortedY = (row - CentreY) / FocalY;
        return Lens == LensModel.Fisheye
            ? FisheyeLens.TryUndistort(this, distortedX, distortedY, out x, out y)
            : BrownConradyLens.TryUndistort(this, distortedX, distortedY, out x, out y);
    }

    /// <summary>
    /// The pixel at which something is seen; false if it is not in front of the camera, or so far aside that the lens
    /// folds: what the formula gives there is another direction's pixel. It may lie outside the picture.
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

        bool isSeen = Lens == LensModel.Fisheye
            ? FisheyeLens.TryDistort(this, x / z, y / z, out double distortedX, out double distortedY)
            : BrownConradyLens.TryDistort(this, x / z, y / z, out distortedX, out distortedY);
        (column, row) = isSeen
            ? ((FocalX * distortedX) + CentreX, (FocalY * distortedY) + CentreY)
            : (double.NaN, double.NaN);
        return isSeen;
    }

    /// <summary>How long after the top row's the middle of the exposure of a row is.</summary>
    internal TimeSpan ReadoutOf(double row) => TimeSpan.FromTicks((long)Math.Round(row / Height * Readout.Ticks));

    /// <summary>What is wrong with it, one line each.</summary>
    internal IEnumerable<string> FindFaults()
    {
        if (Readout < TimeSpan.Zero || Readout > MaxReadout)
        {
            double limit = MaxReadout.ExactMilliseconds;
            yield return FormattableString.Invariant(
                $"the camera's picture is read in {Readout.ExactMilliseconds} ms; it must be 0 to {limit} ms");
        }

        if (Width < 1 || Height < 1)
            yield return FormattableString.Invariant($"the camera's picture is {Width} x {Height}");
        if (!(FocalX > 0 && FocalY > 0) || double.IsInfinity(FocalX + FocalY))
            yield return FormattableString.Invariant(
                $"the camera's focal length is {FocalX}, {FocalY}; it must be above 0");
        if (!(FocalLengthError >= 0 && FocalLengthError < 1))
            yield return FormattableString.Invariant(
                $"the error of the camera's focal length is {FocalLengthError} of it; it must be 0 or above, below 1");
        double sum = CentreX + CentreY + K1 + K2 + P1 + P2 + K3 + K4 + K5 + K6;
        if (Lens is not (LensModel.BrownConrady or LensModel.Fisheye))
            yield return FormattableString.Invariant($"the camera's lens is {Lens}");
        else if (double.IsNaN(sum) || double.IsInfinity(sum))
            yield return "the camera's principal point or distortion is not a number";
        else if (Lens == LensModel.Fisheye && (P1 != 0 || P2 != 0 || K5 != 0 || K6 != 0))
            yield return "the camera is a fisheye, which has k1 to k4 alone, but p1, p2, k5 or k6 is not 0";
        else if (Width > 0 && Height > 0 && FocalX > 0 && FocalY > 0 && !CanUndistortPicture())
            yield return "the camera's distortion cannot be undone over the whole picture";
    }

    // The circle of a fisheye may end within the picture; but a quarter of each side's way is not too much to ask.
    private bool CanUndistortPicture()
        => Lens == LensModel.Fisheye
            ? CanUndistort((Width - 1) * 0.375, (Height - 1) * 0.375, (Width - 1) * 0.625, (Height - 1) * 0.625)
            : CanUndistort(0, 0, Width - 1, Height - 1);

    private bool CanUndistort(double left, double top, double right, double bottom)
    {
        for (int i = 0; i <= 8; i++)
        {
            double column = left + ((right - left) * i / 8);
            double row = top + ((bottom - top) * i / 8);
            if (!TryUndistort(column, top, out _, out _) || !TryUndistort(column, bottom, out _, out _)
                || !TryUndistort(left, row, out _, out _) || !TryUndistort(right, row, out _, out _))
                return false;
        }

        return true;
    }
}
