using System;

namespace Rabit.Vision;

/// <summary>
/// A map between two planes seen in perspective (homography): x = (a u + b v + c) / (g u + h v + 1), y with d, e, f.
/// </summary>
internal struct PlaneMap
{
    public double A;
    public double B;
    public double C;
    public double D;
    public double E;
    public double F;
    public double G;
    public double H;

    /// <summary>Of the square (0, 0), (1, 0), (1, 1), (0, 1) to four corners in this order.</summary>
    /// <remarks>Heckbert, "Fundamentals of texture mapping and image warping", Berkeley 1989, section 2.2.3.</remarks>
    public static PlaneMap ToQuad(in MarkerCorners q)
    {
        double dx1 = q.TopRight.X - q.BottomRight.X;
        double dx2 = q.BottomLeft.X - q.BottomRight.X;
        double sx = q.TopLeft.X - q.TopRight.X + q.BottomRight.X - q.BottomLeft.X;
        double dy1 = q.TopRight.Y - q.BottomRight.Y;
        double dy2 = q.BottomLeft.Y - q.BottomRight.Y;
        double sy = q.TopLeft.Y - q.TopRight.Y + q.BottomRight.Y - q.BottomLeft.Y;
        double det = (dx1 * dy2) - (dx2 * dy1);
        double g = ((sx * dy2) - (dx2 * sy)) / det;
        double h = ((dx1 * sy) - (sx * dy1)) / det;
        return new PlaneMap
        {
            A = q.TopRight.X - q.TopLeft.X + (g * q.TopRight.X),
            B = q.BottomLeft.X - q.TopLeft.X + (h * q.BottomLeft.X),
            C = q.TopLeft.X,
            D = q.TopRight.Y - q.TopLeft.Y + (g * q.TopRight.Y),
            E = q.BottomLeft.Y - q.TopLeft.Y + (h * q.BottomLeft.Y),
            F = q.TopLeft.Y,
            G = g,
            H = h,
        };
    }

    public readonly PicturePoint Map(double u, double v)
    {
        double scale = 1 / ((G * u) + (H * v) + 1);
        return new PicturePoint(((A * u) + (B * v) + C) * scale, ((D * u) + (E * v) + F) * scale);
    }

    /// <summary>
    /// Whether no corner is four times as far away as another: nearer to the line at infinity the map would fold.
    /// </summary>
    public readonly bool IsInFront => !double.IsNaN(G + H) && Math.Min(Math.Min(G, H), G + H) > -0.75
        && Math.Max(Math.Max(G, H), G + H) < 3;
}
