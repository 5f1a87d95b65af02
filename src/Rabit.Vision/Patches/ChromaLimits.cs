using System;

namespace Rabit.Vision;

/// <summary>
/// How much colour the entries of a <see cref="PatchTable"/> have at least, by how strong their strongest channel is:
/// what has less is of none of its colours. Grass is green before all, which few colours of targets are, so those are
/// apart. Chroma is the strongest channel without the weakest one; levels, rounded down to the steps of the table.
/// </summary>
internal sealed class ChromaLimits
{
    /// <summary>How many steps of the strongest channel there are.</summary>
    public const int Count = 16;

    private const int Shift = 8 - PatchTable.Bits;
    private const byte None = 255;

    /// <summary>Finds the limits of a table.</summary>
    public ChromaLimits(byte[] entries)
    {
        Fill(WhereGreenIsStrongest);
        Fill(Elsewhere);
        for (int index = 0; index < entries.Length; index++)
        {
            if (entries[index] != 0)
                Include(Level(index >> (2 * PatchTable.Bits)), Level(index >> PatchTable.Bits), Level(index));
        }
    }

    /// <summary>
    /// By a sixteenth of the strongest channel, where that is green and red is weaker; more than any chroma where there
    /// is no entry.
    /// </summary>
    public byte[] WhereGreenIsStrongest { get; } = new byte[Count];

    /// <summary>The same for all others.</summary>
    public byte[] Elsewhere { get; } = new byte[Count];

    private static int Level(int step) => (step & ((1 << PatchTable.Bits) - 1)) << Shift;

    private static void Fill(byte[] limits)
    {
        for (int i = 0; i < limits.Length; i++)
            limits[i] = None;
    }

    private void Include(int red, int green, int blue)
    {
        int most = Math.Max(red, Math.Max(green, blue));
        int chroma = most - Math.Min(red, Math.Min(green, blue));
        byte[] limits = green == most && red != most ? WhereGreenIsStrongest : Elsewhere;
        limits[most >> 4] = (byte)Math.Min(limits[most >> 4], chroma);
    }
}
