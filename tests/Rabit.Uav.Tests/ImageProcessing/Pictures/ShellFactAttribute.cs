using System;
using System.IO;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>A test that needs a shell as other program.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class ShellFactAttribute : FactAttribute
{
    public ShellFactAttribute()
    {
        if (!File.Exists("/bin/sh"))
            Skip = "There is no /bin/sh here, which stands in for the program of a camera.";
    }
}
