using System;

namespace Rabit.Vision;

/// <summary>The smallest rectangle around points, in the unit and the axes of the points. A plain value.</summary>
/// <param name="length">Its longer side.</param>
/// <param name="width">Its shorter side.</param>
/// <param name="angleRadians">Of the longer side from the first axis towards the second one, 0 to pi.</param>
public readonly struct FittedRectangle(double length, double width, double angleRadians)
    : IEquatable<FittedRectangle>
{
    private const int CoarseSteps = 30;
    private const int FineSteps = 12;

    /// <summary>Its longer side.</summary>
    public double Length { get; } = length;

    /// <summary>Its shorter side.</summary>
    public double Width { get; } = width;

    /// <summary>Of the longer side from the first axis towards the second one, 0 to pi.</summary>
    public double AngleRadians { get; } = angleRadians;

    /// <summary>Whether two are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(FittedRectangle left, FittedRectangle right) => left.Equals(right);

    /// <summary>Whether two differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(FittedRectangle left, FittedRectangle right) => !left.Equals(right);

    /// <summary>Fits one, to half a degree.</summary>
    /// <param name="points">At least one.</param>
    /// <param name="widening">Added to both sides: what a point stands for is not a point.</param>
    public static FittedRectangle Of(ReadOnlySpan<PicturePoint> points, double widening)
    {
        (double best, double bestAngle) = (double.PositiveInfinity, 0);
        (double along, double across) = (0, 0);
        const double coarse = Math.PI / 2 / CoarseSteps;
        for (int step = 0; step < CoarseSteps; step++)
            Try(points, step * coarse, widening, ref best, ref bestAngle, ref along, ref across);
        double from = bestAngle - coarse;
        const double fine = 2 * coarse / FineSteps;
        for (int step = 0; step <= FineSteps; step++)
            Try(points, from + (step * fine), widening, ref best, ref bestAngle, ref along, ref across);
        double angle = along >= across ? bestAngle : bestAngle + (Math.PI / 2);
        return new FittedRectangle(
            Math.Max(along, across), Math.Min(along, across), angle - (Math.PI * Math.Floor(angle / Math.PI)));
    }

    /// <inheritdoc/>
    public bool Equals(FittedRectangle other)
        => Length.Equals(other.Length) && Width.Equals(other.Width) && AngleRadians.Equals(other.AngleRadians);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is FittedRectangle other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((Length.GetHashCode() * 397) ^ AngleRadians.GetHashCode());

    private static void Try(
        ReadOnlySpan<PicturePoint> points, double angle, double widening, ref double best, ref double bestAngle,
        ref double along, ref double across)
    {
        (double cos, double sin) = (Trig.Cos(angle), Trig.Sin(angle));
        (double minU, double maxU) = (double.PositiveInfinity, double.NegativeInfinity);
        (double minV, double maxV) = (double.PositiveInfinity, double.NegativeInfinity);
        foreach (PicturePoint point in points)
        {
            double u = (point.X * cos) + (point.Y * sin);
            double v = (point.Y * cos) - (point.X * sin);
            (minU, maxU) = (Math.Min(minU, u), Math.Max(maxU, u));
            (minV, maxV) = (Math.Min(minV, v), Math.Max(maxV, v));
        }

        double area = (maxU - minU + widening) * (maxV - minV + widening);
        if (area >= best)
            return;
        (best, bestAngle) = (area, angle);
        (along, across) = (maxU - minU + widening, maxV - minV + widening);
    }
}
