using System;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.VideoDevices;

/// <summary>A theory on Linux; skipped elsewhere.</summary>
public sealed class LinuxTheoryAttribute : TheoryAttribute
{
    public LinuxTheoryAttribute()
    {
        if (!OperatingSystem.IsLinux())
            Skip = "This is for Linux.";
    }
}
