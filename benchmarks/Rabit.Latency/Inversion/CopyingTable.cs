using System;
using Rabit.Core;

namespace Rabit.Latency.Inversion;

/// <summary>A message that copies itself: a table of half a kilobyte.</summary>
internal sealed class CopyingTable : ISelfCopying<CopyingTable>
{
    private readonly double[] _cells = new double[64];

    public CopyingTable Clone()
    {
        var clone = new CopyingTable();
        CopyTo(clone);
        return clone;
    }

    public void CopyTo(CopyingTable target) => Array.Copy(_cells, target._cells, _cells.Length);
}
