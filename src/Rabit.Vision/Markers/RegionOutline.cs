using System;

namespace Rabit.Vision;

/// <summary>
/// The convex outlines of those regions that may be a marker: of the first and last dark pixel of every row. A marker's
/// outline is convex, so that nothing is lost where blur opened its ring. Memory of the picture with most of them; for
/// one thread.
/// </summary>
internal sealed class RegionOutline
{
    private int[] _roots = new int[256];
    private int[] _starts = new int[256];
    private int[] _left = new int[1 << 14];
    private int[] _right = new int[1 << 14];
    private int[] _candidateOf = [];
    private PicturePoint[] _hull = new PicturePoint[512];
    private DarkRegions? _regions;

    /// <summary>How many regions may be a marker.</summary>
    public int Count { get; private set; }

    /// <summary>Takes the regions that are large enough, and notes how far they reach in each row.</summary>
    public void Collect(DarkRegions regions, double minSide, int width, int height)
    {
        _regions = regions;
        Count = 0;
        ReadOnlySpan<DarkRegions.Run> runs = regions.Runs;
        if (_candidateOf.Length < runs.Length)
            _candidateOf = new int[Math.Max(runs.Length, 2 * _candidateOf.Length)];
        int rows = 0;
        for (int i = 0; i < runs.Length; i++)
        {
            ref readonly DarkRegions.Run run = ref runs[i];
            if (run.Parent != i)
            {
                // The root comes before all its runs.
                _candidateOf[i] = _candidateOf[regions.RootOf(i)];
            }
            else if (MayBeMarker(run, minSide, width, height))
            {
                Add(i, rows, run.Box.Height);
                _candidateOf[i] = Count;
                rows += run.Box.Height;
            }
            else
            {
                _candidateOf[i] = 0;
            }

            if (_candidateOf[i] != 0)
                Note(run, runs[_roots[_candidateOf[i] - 1]].Box.Top, _starts[_candidateOf[i] - 1]);
        }
    }

    /// <summary>The box of a region.</summary>
    public RegionBox BoxOf(int index) => _regions!.Runs[_roots[index]].Box;

    /// <summary>The corners of the convex outline of a region, through pixel centres, clockwise from the top.</summary>
    public ReadOnlySpan<PicturePoint> HullOf(int index)
    {
        RegionBox box = BoxOf(index);
        int start = _starts[index];
        if (_hull.Length < (2 * box.Height) + 2)
            _hull = new PicturePoint[4 * box.Height];
        int count = 0;
        for (int row = 0; row < box.Height; row++)
            Push(new PicturePoint(_right[start + row], box.Top + row), 0, ref count);
        int turn = count;
        for (int row = box.Height - 1; row >= 0; row--)
            Push(new PicturePoint(_left[start + row], box.Top + row), turn - 1, ref count);

        // The last one may lie on the line to the first.
        if (count > 2 && _hull[count - 1] == _hull[0])
            count--;
        return new ReadOnlySpan<PicturePoint>(_hull, 0, count);
    }

    private static bool MayBeMarker(in DarkRegions.Run root, double minSide, int width, int height)
    {
        RegionBox box = root.Box;

        // A square that stands on its corner has a box that is larger; one seen at a slant is lower than wide.
        return Math.Max(box.Width, box.Height) >= minSide && Math.Min(box.Width, box.Height) >= minSide / 2
            && root.Pixels >= 2 * Math.Max(box.Width, box.Height)
            && box.Left > 0 && box.Top > 0 && box.Right < width - 1 && box.Bottom < height - 1;
    }

    private void Add(int root, int start, int height)
    {
        if (Count == _roots.Length)
        {
            Array.Resize(ref _roots, 2 * Count);
            Array.Resize(ref _starts, 2 * Count);
        }

        if (_left.Length < start + height)
        {
            Array.Resize(ref _left, Math.Max(2 * _left.Length, start + height));
            Array.Resize(ref _right, _left.Length);
        }

        (_roots[Count], _starts[Count]) = (root, start);
        _left.AsSpan(start, height).Fill(int.MaxValue);
        _right.AsSpan(start, height).Fill(int.MinValue);
        Count++;
    }

    private void Note(in DarkRegions.Run run, int top, int start)
    {
        int at = start + run.Row - top;
        _left[at] = Math.Min(_left[at], run.Left);
        _right[at] = Math.Max(_right[at], run.Right);
    }

    // Andrew's monotone chain: what does not turn clockwise is left out.
    private void Push(PicturePoint next, int first, ref int count)
    {
        while (count >= first + 2 && Turn(_hull[count - 2], _hull[count - 1], next) <= 0)
            count--;
        _hull[count++] = next;
    }

    private static double Turn(PicturePoint a, PicturePoint b, PicturePoint c)
        => ((b.X - a.X) * (c.Y - a.Y)) - ((b.Y - a.Y) * (c.X - a.X));
}
