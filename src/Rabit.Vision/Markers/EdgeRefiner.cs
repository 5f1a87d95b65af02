using System;

namespace Rabit.Vision;

/// <summary>
/// Moves the sides of a quadrilateral to where light turns to dark most steeply, and meets them in its corners.
/// </summary>
internal static class EdgeRefiner
{
    private const double Step = 0.5;
    private const int MaxSamples = 32;

    // Corners are round by the blur: the sides begin a little beside them.
    private const double Clearance = 0.1;

    // Of a side, that shows an edge at all.
    private const double MinShare = 0.5;

    /// <summary>Refines; false where a side has no edge.</summary>
    /// <param name="grey">The picture.</param>
    /// <param name="quad">Clockwise.</param>
    /// <param name="minRise">From dark to light, grey levels.</param>
    /// <param name="roughness">How uncertain a side is by how its samples lie about it, pixels.</param>
    public static bool TryRefine(in GreyView grey, ref MarkerCorners quad, double minRise, out double roughness)
    {
        // Not so far that the other side of the ring of a small marker comes in sight.
        double reach = Math.Max(1.5, Math.Min(3, quad.MinSide / 8));
        Span<EdgeLine> lines = stackalloc EdgeLine[4];
        double sum = 0;
        roughness = 0;
        for (int side = 0; side < 4; side++)
        {
            if (!TryLine(
                grey, quad[side], quad[(side + 1) % 4], reach, minRise, out lines[side], out double variance))
                return false;
            sum += variance;
        }

        roughness = Math.Sqrt(sum / 4);

        Span<PicturePoint> corners = stackalloc PicturePoint[4];
        for (int i = 0; i < 4; i++)
        {
            if (!EdgeLine.TryMeet(lines[(i + 3) % 4], lines[i], out corners[i])
                || corners[i].DistanceTo(quad[i]) > 2 * reach)
                return false;
        }

        quad = new MarkerCorners(corners[0], corners[1], corners[2], corners[3]);
        return true;
    }

    private static bool TryLine(
        in GreyView grey, PicturePoint from, PicturePoint to, double reach, double minRise, out EdgeLine line,
        out double variance)
    {
        (line, variance) = (default, 0);
        double length = from.DistanceTo(to);
        if (length < 2)
            return false;
        double outX = (to.Y - from.Y) / length;
        double outY = (from.X - to.X) / length;
        int count = Math.Max(6, Math.Min(MaxSamples, (int)length));
        Span<double> along = stackalloc double[MaxSamples];
        Span<double> across = stackalloc double[MaxSamples];
        Span<double> weights = stackalloc double[MaxSamples];
        int found = 0;
        for (int i = 0; i < count; i++)
        {
            double share = Clearance + ((1 - (2 * Clearance)) * (i + 0.5) / count);
            double x = from.X + (share * (to.X - from.X));
            double y = from.Y + (share * (to.Y - from.Y));
            if (!TryEdge(grey, x, y, outX, outY, reach, minRise, out double offset))
                continue;
            (along[found], across[found], weights[found]) = (share * length, offset, 1);
            found++;
        }

        if (found < MinShare * count)
            return false;
        line = EdgeLine.Fit(
            along.Slice(0, found), across.Slice(0, found), weights.Slice(0, found), out variance);
        line = line.InPicture(from, to, length, outX, outY);
        return true;
    }

    // The centre of the rise from dark to light on the way out; false if there is none.
    public static bool TryEdge(
        in GreyView grey, double x, double y, double outX, double outY, double reach, double minRise,
        out double offset)
    {
        double sum = 0;
        double moment = 0;
        double rise = 0;
        double last = grey.At(x - (reach * outX), y - (reach * outY));
        int steps = (int)Math.Round(2 * reach / Step);
        for (int i = 1; i <= steps; i++)
        {
            double at = (i * Step) - reach;
            double next = grey.At(x + (at * outX), y + (at * outY));
            double slope = next - last;
            last = next;
            if (slope <= 0)
                continue;
            rise += slope;
            sum += slope * slope;
            moment += slope * slope * (at - (Step / 2));
        }

        offset = sum > 0 ? moment / sum : 0;
        return sum > 0 && rise >= minRise;
    }
}
