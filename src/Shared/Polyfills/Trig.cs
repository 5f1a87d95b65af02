#pragma warning disable RS0030   // This is the twin of what is banned.

namespace System;

/// <summary>
/// Sine and cosine, to the bit the same on each runtime. On x64 Mono computes them by an instruction of the processor
/// (fsin, fcos) where .NET asks the library of C, and the last bits differ; behind a delegate it asks the library too.
/// </summary>
internal static class Trig
{
#if NET
    /// <summary>The sine.</summary>
    public static double Sin(double radians) => Math.Sin(radians);

    /// <summary>The cosine.</summary>
    public static double Cos(double radians) => Math.Cos(radians);
#else
    private static readonly Func<double, double> SinOfLibrary = Math.Sin;
    private static readonly Func<double, double> CosOfLibrary = Math.Cos;

    /// <summary>The sine.</summary>
    public static double Sin(double radians) => SinOfLibrary(radians);

    /// <summary>The cosine.</summary>
    public static double Cos(double radians) => CosOfLibrary(radians);
#endif
}
