using System.Runtime.InteropServices;

namespace Rabit.Latency.Throughput;

/// <summary>A queue entry of one cache line: 64 bytes.</summary>
[StructLayout(LayoutKind.Sequential, Size = 64)]
internal struct Block64
{
    public long Number { get; set; }
}
