namespace Rabit.Vision;

/// <summary>
/// Pixels of one colour side by side in a row, joined with those that touch it: the root of a patch counts its pixels.
/// </summary>
internal struct PatchRun
{
    public int Row;
    public int Left;
    public int Right;

    /// <summary>Towards the run that stands for all possible pixels that touch each other.</summary>
    public int Weak;

    /// <summary>Towards the run that stands for all clear pixels that touch each other.</summary>
    public int Strong;

    public int WeakPixels;
    public int StrongPixels;
    public int WeakPatch;
    public int StrongPatch;

    /// <summary>Of the table of colours.</summary>
    public byte Entry;

    public readonly int Length => Right - Left + 1;

    public readonly int Colour => Entry & ~PatchTable.Strong;

    public readonly bool IsStrong => (Entry & PatchTable.Strong) != 0;
}
