using System.Runtime.InteropServices;

namespace Rabit.Benchmarks.Core;

/// <summary>A queue entry of one cache line: 64 bytes.</summary>
[StructLayout(LayoutKind.Sequential, Size = 64)]
public struct CacheLine
{
    public long Number { get; set; }
}
