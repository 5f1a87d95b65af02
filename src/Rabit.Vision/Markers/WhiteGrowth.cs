using System;

namespace Rabit.Vision;

/// <summary>
/// How far white grows over black at the edges of a marker, and the corners without that. Lens blur, the curve of the
/// camera and clipped light make white areas larger; the outer edges alone cannot distinguish that from a smaller
/// marker, but between the cells there are edges of both senses. Any thread.
/// </summary>
internal static class WhiteGrowth
{
    // More than that is no growth; less than none neither, but noise may look so.
    private const double Most = 1.5;
    private const double Least = -0.3;
    private const int Rounds = 2;

    /// <summary>
    /// Moves the corners to where they are; gives how far the edges between the cells then lie from where they should
    /// be, root of the mean of squares, in cells.
    /// </summary>
    /// <param name="grey">The picture.</param>
    /// <param name="corners">Of the upright marker.</param>
    /// <param name="dictionary">Of the marker.</param>
    /// <param name="code">Its payload.</param>
    /// <param name="growth">Of white over black, pixels.</param>
    public static double Correct(
        in GreyView grey, ref MarkerCorners corners, MarkerDictionary dictionary, ulong code, out double growth)
    {
        MarkerCorners seen = corners;
        growth = 0;
        double misfit = 0;
        for (int round = 0; round < Rounds; round++)
        {
            var fit = default(Fit);
            PlaneMap map = PlaneMap.ToQuad(corners);
            Measure(grey, map, dictionary, code, growth, isRow: true, ref fit);
            Measure(grey, map, dictionary, code, growth, isRow: false, ref fit);
            growth = Math.Max(Least, Math.Min(Most, growth + fit.Solve()));
            corners = Grown(seen, growth);
            misfit = fit.Misfit;
        }

        return misfit;
    }

    // All sides moved outwards.
    private static MarkerCorners Grown(in MarkerCorners quad, double pixels)
    {
        Span<EdgeLine> lines = stackalloc EdgeLine[4];
        for (int i = 0; i < 4; i++)
            lines[i] = EdgeLine.Through(quad[i], quad[(i + 1) % 4], pixels);
        Span<PicturePoint> corners = stackalloc PicturePoint[4];
        for (int i = 0; i < 4; i++)
        {
            if (!EdgeLine.TryMeet(lines[(i + 3) % 4], lines[i], out corners[i]))
                return quad;
        }

        return new MarkerCorners(corners[0], corners[1], corners[2], corners[3]);
    }

    // The edges between two rows of cells, or two columns.
    private static void Measure(
        in GreyView grey, in PlaneMap map, MarkerDictionary dictionary, ulong code, double growth, bool isRow,
        ref Fit fit)
    {
        int cells = dictionary.Cells;
        double size = 1.0 / cells;
        for (int line = 1; line < cells; line++)
        {
            for (int i = 1; i < cells - 1; i++)
            {
                bool before = isRow ? IsWhite(code, line - 1, i, cells) : IsWhite(code, i, line - 1, cells);
                bool after = isRow ? IsWhite(code, line, i, cells) : IsWhite(code, i, line, cells);
                if (before == after)
                    continue;
                double along = (i + 0.5) * size;
                PicturePoint at = isRow ? map.Map(along, line * size) : map.Map(line * size, along);
                PicturePoint next = isRow
                    ? map.Map(along, (line + 0.5) * size) : map.Map((line + 0.5) * size, along);
                double reach = at.DistanceTo(next);
                int toBlack = before ? 1 : -1;
                double x = toBlack * (next.X - at.X) / reach;
                double y = toBlack * (next.Y - at.Y) / reach;
                if (EdgeRefiner.TryEdge(
                    grey, at.X + (growth * x), at.Y + (growth * y), -x, -y, Math.Min(reach, 3), 0, out double outwards))
                    fit.Add(1 + (toBlack * ((2 * line * size) - 1)), -outwards, 2 * reach);
                else
                    fit.AddMissing();
            }
        }
    }

    private static bool IsWhite(ulong code, int row, int column, int cells)
    {
        int side = cells - 2;
        return row >= 1 && row <= side && column >= 1 && column <= side
            && ((code >> ((side * side) - 1 - (((row - 1) * side) + column - 1))) & 1) != 0;
    }

    // Where an edge of the marker was found, by how much of the growth shows there: none at the outer edges, to which
    // the corners were fitted.
    private struct Fit
    {
        private double _square;
        private double _product;
        private double _off;
        private int _count;

        /// <summary>Of the edges from what they should be before this fit, in cells.</summary>
        public readonly double Misfit => _count > 0 ? Math.Sqrt(_off / _count) : 0;

        public void Add(double factor, double found, double cell)
        {
            _square += factor * factor;
            _product += factor * found;
            _off += found * found / (cell * cell);
            _count++;
        }

        // Half a cell off is the most that can be found.
        public void AddMissing()
        {
            _off += 0.25;
            _count++;
        }

        public readonly double Solve() => _square > 0 ? _product / _square : 0;
    }
}
