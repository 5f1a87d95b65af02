using System.Runtime.InteropServices;

namespace Rabit.Latency.Throughput;

/// <summary>What one side of a ring writes, away from everything else by a pair of cache lines.</summary>
[StructLayout(LayoutKind.Explicit, Size = 256)]
internal struct RingSide
{
    [FieldOffset(128)]
    public int Own;         // written by its side, read by both

    [FieldOffset(132)]
    public int SeenOther;   // its side's alone
}
