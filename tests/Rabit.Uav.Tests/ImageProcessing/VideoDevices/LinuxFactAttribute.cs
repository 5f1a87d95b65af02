using System;
using System.IO;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.VideoDevices;

/// <summary>A test of Linux.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class LinuxFactAttribute : FactAttribute
{
    public LinuxFactAttribute()
    {
        if (!Directory.Exists("/proc/self"))
            Skip = "This is not Linux, which has Video4Linux.";
    }
}

/// <summary>A test that needs the kernel's virtual camera, or another video device.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class VideoDeviceFactAttribute : FactAttribute
{
    public const string Device = "/dev/video0";

    public VideoDeviceFactAttribute()
    {
        if (!File.Exists(Device))
            Skip = $"There is no {Device} here; the kernel's virtual camera makes one (modprobe vivid).";
    }
}
