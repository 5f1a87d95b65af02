using System;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>A test that needs the real ffmpeg, and is skipped where it is not installed.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class FfmpegTheoryAttribute : TheoryAttribute
{
    public FfmpegTheoryAttribute()
    {
        string path = Environment.GetEnvironmentVariable("PATH") ?? "";
        if (!path.Split(Path.PathSeparator).Any(f => f.Length > 0 && File.Exists(Path.Combine(f, "ffmpeg"))))
            Skip = "There is no ffmpeg in PATH (apt-get install ffmpeg), so a real one was not read.";
    }
}
