using System;
using System.Runtime.InteropServices;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>Where last bits are those of the C library of Linux on x64; skipped elsewhere.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class LinuxX64FactAttribute : FactAttribute
{
    public LinuxX64FactAttribute()
    {
        if (!OperatingSystem.IsLinux() || RuntimeInformation.ProcessArchitecture != Architecture.X64)
            Skip = "The last bits of sines are those of glibc on x64.";
    }
}
