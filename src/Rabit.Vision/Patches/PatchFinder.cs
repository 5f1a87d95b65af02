using System;

namespace Rabit.Vision;

/// <summary>
/// Finds patches of the colours of a table, twice: of the pixels whose colour is clear, and of all of which it is
/// possible, so that a target on ground of a like colour is a patch of its own, and a small pale one is a patch too.
/// Fixed memory; for one thread.
/// </summary>
public sealed class PatchFinder
{
    /// <summary>Maximum of runs of a picture. One with more is noise, and not ground with targets on it.</summary>
    public const int MaxRuns = 131_072;

    /// <summary>Maximum of patches of a picture, each of at least <see cref="MinPixels"/>.</summary>
    public const int MaxPatches = 16_384;

    /// <summary>Smaller ones are left out.</summary>
    public const int MinPixels = 3;

    private readonly PatchRuns _runs = new();
    private readonly Patch[] _patches = new Patch[MaxPatches];

    /// <summary>How many patches the last picture had.</summary>
    public int Count { get; private set; }

    /// <summary>The patches of the last picture.</summary>
    public ReadOnlySpan<Patch> Patches => new(_patches, 0, Count);

    /// <summary>
    /// Finds all patches; false if there are more than fit in, so that the picture was not searched. Allocates nothing
    /// after the first picture of a height.
    /// </summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="table">The colours.</param>
    /// <param name="light">Of this picture.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public bool TryFind(byte[] pixels, int width, int height, PatchTable table, PictureLight light)
    {
        PixelBuffer.Check(pixels, width, height);
        if (table is null)
            throw new ArgumentNullException(nameof(table));
        if (light is null)
            throw new ArgumentNullException(nameof(light));
        Count = 0;
        return _runs.TryFind(pixels, width, height, table, light) && TryCollect();
    }

    /// <summary>Sets the bit of each pixel of a patch in a grid that begins at a column and row.</summary>
    internal void Draw(in Patch patch, BitGrid grid, int left, int top)
    {
        for (int row = patch.Top; row <= patch.Bottom; row++)
        {
            int end = _runs.StartOf(row + 1);
            for (int i = _runs.FirstOf(row, patch.Left); i < end && _runs[i].Left <= patch.Right; i++)
            {
                if (IsOf(i, patch))
                    grid.Set(row - top, _runs[i].Left - left, _runs[i].Right - left);
            }
        }
    }

    private bool IsOf(int run, in Patch patch)
        => patch.IsStrong
            ? _runs[run].IsStrong && _runs.StrongRootOf(run) == patch.Root
            : _runs.WeakRootOf(run) == patch.Root;

    // First how large each is, at its root; then those that are large enough.
    private bool TryCollect()
    {
        for (int i = 0; i < _runs.Count; i++)
        {
            _runs[_runs.WeakRootOf(i)].WeakPixels += _runs[i].Length;
            if (_runs[i].IsStrong)
                _runs[_runs.StrongRootOf(i)].StrongPixels += _runs[i].Length;
        }

        for (int i = 0; i < _runs.Count; i++)
        {
            int weak = _runs.WeakRootOf(i);
            if (_runs[weak].WeakPixels >= MinPixels && !TryAdd(i, weak, isStrong: false))
                return false;
            if (!_runs[i].IsStrong)
                continue;
            int strong = _runs.StrongRootOf(i);
            if (_runs[strong].StrongPixels >= MinPixels && _runs[strong].StrongPixels != _runs[weak].WeakPixels
                && !TryAdd(i, strong, isStrong: true))
                return false;
        }

        return true;
    }

    private bool TryAdd(int i, int root, bool isStrong)
    {
        ref PatchRun run = ref _runs[i];
        if (root == i)
        {
            if (Count == MaxPatches)
                return false;
            if (isStrong)
                run.StrongPatch = Count;
            else
                run.WeakPatch = Count;
            _patches[Count++] = new Patch
            {
                Colour = run.Colour - 1,
                IsStrong = isStrong,
                Left = run.Left,
                Right = run.Right,
                Top = run.Row,
                Bottom = run.Row,
                Pixels = run.Length,
                Runs = 1,
                Root = i,
            };
            return true;
        }

        ref Patch patch = ref _patches[isStrong ? _runs[root].StrongPatch : _runs[root].WeakPatch];
        patch.Left = Math.Min(patch.Left, run.Left);
        patch.Right = Math.Max(patch.Right, run.Right);
        patch.Bottom = run.Row;
        patch.Pixels += run.Length;
        patch.Runs++;
        return true;
    }
}
