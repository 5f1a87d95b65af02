using System;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// For each pixel the ray that falls on its centre, as it is before the lens: x to the right and y down at a distance
/// of 1 along the optical axis. The lens is Brown-Conrady's, which says where a ray falls; where a pixel's ray comes
/// from is found by Newton's method. Immutable.
/// </summary>
internal sealed class LensRays
{
    private const int MaxSteps = 30;
    private const double Converged = 1e-13;

    private readonly CameraModel _camera;
    private readonly double[] _rays;

    /// <exception cref="ArgumentException">
    /// The distortion is such that no ray falls on some pixel, or that none can be found.
    /// </exception>
    public LensRays(CameraModel camera)
    {
        _camera = camera;
        _rays = new double[camera.Width * camera.Height * 2];
        (MinX, MaxX, MinY, MaxY) = (double.MaxValue, double.MinValue, double.MaxValue, double.MinValue);
        int at = 0;
        for (int v = 0; v < camera.Height; v++)
        {
            for (int u = 0; u < camera.Width; u++)
            {
                (double x, double y) = Undistort(u, v);
                (_rays[at], _rays[at + 1]) = (x, y);
                (MinX, MaxX) = (Math.Min(MinX, x), Math.Max(MaxX, x));
                (MinY, MaxY) = (Math.Min(MinY, y), Math.Max(MaxY, y));
                at += 2;
            }
        }
    }

    public int Width => _camera.Width;

    public int Height => _camera.Height;

    /// <summary>x and y of each pixel, row by row. Not to be written.</summary>
    public double[] Rays => _rays;

    /// <summary>The bounds of all rays.</summary>
    public double MinX { get; }

    /// <inheritdoc cref="MinX"/>
    public double MaxX { get; }

    /// <inheritdoc cref="MinX"/>
    public double MinY { get; }

    /// <inheritdoc cref="MinX"/>
    public double MaxY { get; }

    /// <summary>How many pixels a step of 1 across the optical axis is at distance 1.</summary>
    public double Focal => (_camera.FocalX + _camera.FocalY) / 2;

    /// <summary>Where a ray falls, pixels.</summary>
    public (double U, double V) Project(double x, double y)
    {
        (double xd, double yd) = Distort(x, y);
        return ((_camera.FocalX * xd) + _camera.CentreX, (_camera.FocalY * yd) + _camera.CentreY);
    }

    private (double X, double Y) Distort(double x, double y)
    {
        double r2 = (x * x) + (y * y);
        double radial = 1 + (r2 * (_camera.K1 + (r2 * (_camera.K2 + (r2 * _camera.K3)))));
        return (
            (x * radial) + (2 * _camera.P1 * x * y) + (_camera.P2 * (r2 + (2 * x * x))),
            (y * radial) + (_camera.P1 * (r2 + (2 * y * y))) + (2 * _camera.P2 * x * y));
    }

    private (double X, double Y) Undistort(double u, double v)
    {
        double xd = (u - _camera.CentreX) / _camera.FocalX;
        double yd = (v - _camera.CentreY) / _camera.FocalY;
        (double x, double y) = (xd, yd);
        for (int step = 0; step < MaxSteps; step++)
        {
            (double fx, double fy) = Distort(x, y);
            (fx, fy) = (fx - xd, fy - yd);
            double r2 = (x * x) + (y * y);
            double radial = 1 + (r2 * (_camera.K1 + (r2 * (_camera.K2 + (r2 * _camera.K3)))));
            // of radial, by r, over r
            double slope = 2 * (_camera.K1 + (r2 * ((2 * _camera.K2) + (r2 * 3 * _camera.K3))));
            double dxx = radial + (x * x * slope) + (2 * _camera.P1 * y) + (6 * _camera.P2 * x);
            double dyy = radial + (y * y * slope) + (6 * _camera.P1 * y) + (2 * _camera.P2 * x);
            double dxy = (x * y * slope) + (2 * _camera.P1 * x) + (2 * _camera.P2 * y);
            double determinant = (dxx * dyy) - (dxy * dxy);
            if (!(determinant > 0))
                break;   // beyond the fold, where the picture would turn inside out
            if (Math.Abs(fx) + Math.Abs(fy) < Converged)
                return (x, y);
            x -= ((dyy * fx) - (dxy * fy)) / determinant;
            y -= ((dxx * fy) - (dxy * fx)) / determinant;
        }

        throw new ArgumentException(
            $"Simulated camera: with this distortion no ray of light falls on pixel ({u}, {v}).", nameof(u));
    }
}
