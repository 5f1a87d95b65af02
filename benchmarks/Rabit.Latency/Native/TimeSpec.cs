using System;
using System.Runtime.InteropServices;

namespace Rabit.Latency.Native;

/// <summary>struct timespec: both members are as long as a pointer on x64, arm64 and arm.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct TimeSpec
{
    public IntPtr Seconds;
    public IntPtr Nanoseconds;

    public readonly long TotalNanoseconds => ((long)Seconds * 1_000_000_000) + (long)Nanoseconds;

    public static TimeSpec FromNanoseconds(long nanoseconds)
        => new()
        {
            Seconds = new IntPtr(nanoseconds / 1_000_000_000),
            Nanoseconds = new IntPtr(nanoseconds % 1_000_000_000)
        };
}
