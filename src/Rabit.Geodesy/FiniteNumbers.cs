namespace Rabit.Geodesy;

/// <summary>What .NET Standard 2.0 has no method for.</summary>
internal static class FiniteNumbers
{
    /// <summary>Whether it is a number, and not an infinite one.</summary>
    public static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);

    /// <summary>Whether all three are.</summary>
    public static bool AreFinite(double a, double b, double c) => IsFinite(a) && IsFinite(b) && IsFinite(c);
}
