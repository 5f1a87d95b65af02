using System.Runtime.InteropServices;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>Head and tail on cache lines of their own. (A generic class cannot have a struct with such a layout inside.)</summary>
[StructLayout(LayoutKind.Explicit, Size = 384)]
internal struct SpscPositions
{
    [FieldOffset(128)]
    public int Tail;
    [FieldOffset(132)]
    public int SeenHead;
    [FieldOffset(256)]
    public int Head;
    [FieldOffset(260)]
    public int SeenTail;
}
