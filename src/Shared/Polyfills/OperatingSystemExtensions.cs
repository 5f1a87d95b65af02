#if !NET
using System.Runtime.InteropServices;

namespace System;

/// <summary>What <see cref="OperatingSystem"/> lacks on netstandard2.0 and the .NET Framework.</summary>
internal static class OperatingSystemExtensions
{
    extension(OperatingSystem)
    {
        /// <summary>Whether the program runs on Linux.</summary>
        public static bool IsLinux() => RuntimeInformation.IsOSPlatform(OSPlatform.Linux);
    }
}
#endif
