using System;

namespace Rabit.Vision;

/// <summary>A line nx x + ny y = c, the normal of length 1. While it is fitted: across = c + slope x along.</summary>
internal struct EdgeLine
{
    public double NormalX;
    public double NormalY;
    public double Offset;
    private double _slope;

    /// <summary>By least squares, once more without what lies furthest off.</summary>
    /// <param name="along">Where the samples are.</param>
    /// <param name="across">What was found there.</param>
    /// <param name="weights">One for each sample at the start.</param>
    /// <param name="variance">Of the line at its ends.</param>
    public static EdgeLine Fit(
        ReadOnlySpan<double> along, ReadOnlySpan<double> across, Span<double> weights, out double variance)
    {
        EdgeLine line = FitOnce(along, across, weights);
        for (int round = 0; round < 2; round++)
        {
            double sum = 0;
            for (int i = 0; i < along.Length; i++)
                sum += Math.Abs(across[i] - line.Offset - (line._slope * along[i]));
            double limit = Math.Max(0.15, 1.5 * sum / along.Length);
            for (int i = 0; i < along.Length; i++)
            {
                double off = Math.Abs(across[i] - line.Offset - (line._slope * along[i]));
                weights[i] = off <= limit ? 1 : limit / off * (limit / off);
            }

            line = FitOnce(along, across, weights);
        }

        // At its ends a line is about four times as uncertain as its mean (variance).
        double square = 0;
        for (int i = 0; i < along.Length; i++)
        {
            double off = across[i] - line.Offset - (line._slope * along[i]);
            square += weights[i] * off * off;
        }

        variance = 4 * square / (along.Length * along.Length);
        return line;
    }

    /// <summary>
    /// The line through two points, moved to the left of the way from one to the other: out of a quad.
    /// </summary>
    public static EdgeLine Through(PicturePoint from, PicturePoint to, double outwards)
    {
        double length = from.DistanceTo(to);
        double nx = (to.Y - from.Y) / length;
        double ny = (from.X - to.X) / length;
        return new EdgeLine
        {
            NormalX = nx,
            NormalY = ny,
            Offset = (from.X * nx) + (from.Y * ny) + outwards,
        };
    }

    /// <summary>Where two lines meet; false if they are parallel.</summary>
    public static bool TryMeet(in EdgeLine a, in EdgeLine b, out PicturePoint point)
    {
        double det = (a.NormalX * b.NormalY) - (a.NormalY * b.NormalX);
        point = new PicturePoint(
            ((a.Offset * b.NormalY) - (a.NormalY * b.Offset)) / det,
            ((a.NormalX * b.Offset) - (a.Offset * b.NormalX)) / det);
        return Math.Abs(det) > 0.05;
    }

    /// <summary>The line through the picture that a fit beside a side of a quadrilateral is.</summary>
    public readonly EdgeLine InPicture(PicturePoint from, PicturePoint to, double length, double outX, double outY)
    {
        double dx = (to.X - from.X) / length;
        double dy = (to.Y - from.Y) / length;
        double nx = outX - (_slope * dx);
        double ny = outY - (_slope * dy);
        double size = Math.Sqrt((nx * nx) + (ny * ny));
        return new EdgeLine
        {
            NormalX = nx / size,
            NormalY = ny / size,
            Offset = (((from.X + (Offset * outX)) * nx) + ((from.Y + (Offset * outY)) * ny)) / size,
        };
    }

    private static EdgeLine FitOnce(
        ReadOnlySpan<double> along, ReadOnlySpan<double> across, ReadOnlySpan<double> weights)
    {
        double w = 0;
        double s = 0;
        double t = 0;
        double ss = 0;
        double st = 0;
        for (int i = 0; i < along.Length; i++)
        {
            w += weights[i];
            s += weights[i] * along[i];
            t += weights[i] * across[i];
            ss += weights[i] * along[i] * along[i];
            st += weights[i] * along[i] * across[i];
        }

        double det = (w * ss) - (s * s);
        double slope = det > 1e-9 ? ((w * st) - (s * t)) / det : 0;
        return new EdgeLine { _slope = slope, Offset = (t - (slope * s)) / w };
    }
}
