using System.Diagnostics;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Ends a program with all that it has started; see the twin for netstandard2.0.</summary>
internal static class ProcessTree
{
    /// <exception cref="System.InvalidOperationException">It has ended.</exception>
    public static void Kill(Process process) => process.Kill(entireProcessTree: true);
}
