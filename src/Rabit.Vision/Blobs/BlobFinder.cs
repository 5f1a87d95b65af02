using System;

namespace Rabit.Vision;

/// <summary>
/// Finds the blobs of a picture: row by row into runs of one colour, runs that touch (also at a corner) joined by
/// union-find. Fixed memory; for one thread.
/// </summary>
/// <remarks>
/// Rosenfeld and Pfaltz, "Sequential operations in digital picture processing", Journal of the ACM 13(4), 1966.
/// </remarks>
/// <example>
/// <code>
/// var finder = new BlobFinder();                    // kept from picture to picture
/// if (finder.TryFind(picture.Pixels, picture.Width, picture.Height, table))
/// {
///     foreach (Blob blob in finder.Blobs)
///         Console.WriteLine($"{blob.Pixels} pixels from column {blob.Left} to {blob.Right}");
/// }
/// </code>
/// </example>
public sealed class BlobFinder
{
    /// <summary>Maximum of runs of a picture. One with more is noise, and not ground with targets on it.</summary>
    public const int MaxRuns = 32_768;

    /// <summary>Maximum of blobs of a picture.</summary>
    public const int MaxBlobs = 4_096;

    private readonly Run[] _runs = new Run[MaxRuns];
    private readonly Blob[] _blobs = new Blob[MaxBlobs];
    private int _runCount;

    /// <summary>The blobs of the last picture.</summary>
    public ReadOnlySpan<Blob> Blobs => new(_blobs, 0, Count);

    /// <summary>How many blobs the last picture had.</summary>
    public int Count { get; private set; }

    /// <summary>
    /// Finds all blobs; false if there are more than fit in, so that the picture was not searched. Allocates nothing.
    /// </summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="colours">The classes of colours that blobs are made of.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public bool TryFind(byte[] pixels, int width, int height, ColourTable colours)
    {
        PixelBuffer.Check(pixels, width, height);
        byte[] classes = (colours ?? throw new ArgumentNullException(nameof(colours))).Classes;
        Count = 0;
        _runCount = 0;
        int above = 0;
        for (int row = 0; row < height; row++)
        {
            int first = _runCount;
            if (!TryAddRuns(pixels, row * width * 3, width, classes))
                return false;
            Join(above, first);
            above = first;
            NoteRow(first, row);
        }

        return TryCollect();
    }

    // The loop over all pixels.
    private unsafe bool TryAddRuns(byte[] pixels, int start, int width, byte[] classes)
    {
        fixed (byte* begin = &pixels[start])
        fixed (byte* table = classes)
        {
            byte* end = begin + (3 * width);
            byte* p = begin;
            while (true)
            {
                int colour = 0;
                while (p < end && (colour = ClassAt(p, table)) == 0)
                    p += 3;
                if (p == end)
                    return true;
                if (_runCount == MaxRuns)
                    return false;
                byte* from = p;
                do
                    p += 3;
                while (p < end && ClassAt(p, table) == colour);
                ref Run run = ref _runs[_runCount];
                run.Left = (int)(from - begin) / 3;
                run.Right = ((int)(p - begin) / 3) - 1;
                run.Class = (byte)colour;
                run.Parent = _runCount++;
            }
        }
    }

    private static unsafe int ClassAt(byte* p, byte* table) => table[
        ((p[0] >> ColourTable.Shift) << (2 * ColourTable.Bits))
        | ((p[1] >> ColourTable.Shift) << ColourTable.Bits)
        | (p[2] >> ColourTable.Shift)];

    private void NoteRow(int first, int row)
    {
        for (int i = first; i < _runCount; i++)
            _runs[i].Row = row;
    }

    // Both rows from left to right, as in a merge.
    private void Join(int above, int first)
    {
        int a = above;
        for (int b = first; b < _runCount; b++)
        {
            ref Run run = ref _runs[b];
            while (a < first && _runs[a].Right < run.Left - 1)
                a++;
            for (int c = a; c < first && _runs[c].Left <= run.Right + 1; c++)
            {
                if (_runs[c].Class == run.Class)
                    Unite(b, c);
            }
        }
    }

    // The smaller root stays, so that a root comes before all its runs.
    private void Unite(int a, int b)
    {
        a = RootOf(a);
        b = RootOf(b);
        if (a < b)
            _runs[b].Parent = a;
        else
            _runs[a].Parent = b;
    }

    private int RootOf(int run)
    {
        while (_runs[run].Parent != run)
        {
            _runs[run].Parent = _runs[_runs[run].Parent].Parent;
            run = _runs[run].Parent;
        }

        return run;
    }

    private bool TryCollect()
    {
        for (int i = 0; i < _runCount; i++)
        {
            ref Run run = ref _runs[i];
            int root = RootOf(i);
            if (root == i)
            {
                if (Count == MaxBlobs)
                    return false;
                run.Blob = Count;
                _blobs[Count++] = new Blob
                {
                    Class = run.Class,
                    Left = run.Left,
                    Right = run.Right,
                    Top = run.Row,
                    Bottom = run.Row,
                    Pixels = run.Right - run.Left + 1,
                };
                continue;
            }

            ref Blob blob = ref _blobs[_runs[root].Blob];
            blob.Left = Math.Min(blob.Left, run.Left);
            blob.Right = Math.Max(blob.Right, run.Right);
            blob.Bottom = run.Row;
            blob.Pixels += run.Right - run.Left + 1;
        }

        return true;
    }

    private struct Run
    {
        public int Row;
        public int Left;
        public int Right;
        public int Parent;
        public int Blob;
        public byte Class;
    }
}
