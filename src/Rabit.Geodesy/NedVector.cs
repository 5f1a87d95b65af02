namespace Rabit.Geodesy;

/// <summary>A vector in the local north-east-down frame. The name of what holds it says its unit. A plain value.</summary>
/// <param name="north">To true north.</param>
/// <param name="east">To the east.</param>
/// <param name="down">Towards the ground.</param>
public readonly struct NedVector(double north, double east, double down)
{
    /// <summary>To true north.</summary>
    public double North { get; } = north;

    /// <summary>To the east.</summary>
    public double East { get; } = east;

    /// <summary>Towards the ground.</summary>
    public double Down { get; } = down;
}
