namespace Rabit.Geodesy;

/// <summary>A vector in the body frame, forward-right-down. The name of what holds it says its unit. A plain value.</summary>
/// <param name="forward">Along the nose.</param>
/// <param name="right">Along the right wing.</param>
/// <param name="down">Through the floor.</param>
public readonly struct BodyVector(double forward, double right, double down)
{
    /// <summary>Along the nose.</summary>
    public double Forward { get; } = forward;

    /// <summary>Along the right wing.</summary>
    public double Right { get; } = right;

    /// <summary>Through the floor.</summary>
    public double Down { get; } = down;
}
