using System;

namespace Rabit.Vision;

/// <summary>Finds the quadrilateral of largest area in a convex outline, and judges whether it fills it.</summary>
internal static class QuadFitter
{
    // A square fills its outline, a hexagon two thirds of it, a circle as much; small ones have round corners.
    private const double MinFill = 0.82;
    private const int MaxRounds = 8;

    /// <summary>Fits; false if the outline is none of a marker.</summary>
    /// <param name="hull">Clockwise, as seen in the picture.</param>
    /// <param name="minSide">Side of the smallest marker, pixels.</param>
    /// <param name="quad">Clockwise.</param>
    public static bool TryFit(ReadOnlySpan<PicturePoint> hull, double minSide, out MarkerCorners quad)
    {
        quad = default;
        if (hull.Length < 4)
            return false;
        Span<int> at = stackalloc int[4];
        FindDiagonal(hull, out at[0], out at[2]);
        at[1] = Furthest(hull, at[0], at[2]);
        at[3] = Furthest(hull, at[2], at[0]);
        if (at[1] < 0 || at[3] < 0)
            return false;
        Improve(hull, at);
        quad = new MarkerCorners(hull[at[0]], hull[at[1]], hull[at[2]], hull[at[3]]);
        double area = Area(quad);
        return area >= MinFill * Area(hull) && quad.MinSide >= minSide * 0.75
            && area >= 0.3 * minSide * minSide;
    }

    /// <summary>The area of a quadrilateral; above 0 for a clockwise one.</summary>
    public static double Area(in MarkerCorners q)
        => (((q.BottomRight.X - q.TopLeft.X) * (q.BottomLeft.Y - q.TopRight.Y))
            - ((q.BottomRight.Y - q.TopLeft.Y) * (q.BottomLeft.X - q.TopRight.X))) / 2;

    private static double Area(ReadOnlySpan<PicturePoint> hull)
    {
        double sum = 0;
        PicturePoint last = hull[hull.Length - 1];
        foreach (PicturePoint next in hull)
        {
            sum += (last.X * next.Y) - (last.Y * next.X);
            last = next;
        }

        return sum / 2;
    }

    // From the outermost of four directions: near to the longest there is, and as good for what follows.
    private static void FindDiagonal(ReadOnlySpan<PicturePoint> hull, out int from, out int to)
    {
        from = 0;
        for (int round = 0; ; round++)
        {
            to = FurthestFrom(hull, from);
            int back = FurthestFrom(hull, to);
            if (back == from || round == MaxRounds)
                break;
            from = back;
        }
    }

    private static int FurthestFrom(ReadOnlySpan<PicturePoint> hull, int from)
    {
        int best = from;
        double most = 0;
        for (int i = 0; i < hull.Length; i++)
        {
            double dx = hull[i].X - hull[from].X;
            double dy = hull[i].Y - hull[from].Y;
            double distance = (dx * dx) + (dy * dy);
            if (distance > most)
                (best, most) = (i, distance);
        }

        return best;
    }

    // On the way clockwise from one to the other, the corner furthest from the line between them; -1 if there is none.
    private static int Furthest(ReadOnlySpan<PicturePoint> hull, int from, int to)
    {
        double dx = hull[to].X - hull[from].X;
        double dy = hull[to].Y - hull[from].Y;
        int best = -1;
        double most = 0;
        for (int i = (from + 1) % hull.Length; i != to; i = (i + 1) % hull.Length)
        {
            double distance = (dy * (hull[i].X - hull[from].X)) - (dx * (hull[i].Y - hull[from].Y));
            if (distance > most)
                (best, most) = (i, distance);
        }

        return best;
    }

    // Each corner goes to where its triangle is largest, until none moves.
    private static void Improve(ReadOnlySpan<PicturePoint> hull, Span<int> at)
    {
        bool moved = true;
        for (int round = 0; moved && round < MaxRounds; round++)
        {
            moved = false;
            for (int i = 0; i < 4; i++)
            {
                int best = Furthest(hull, at[(i + 3) % 4], at[(i + 1) % 4]);
                if (best < 0 || best == at[i])
                    continue;
                moved = true;
                at[i] = best;
            }
        }
    }
}
