namespace Rabit.Uav.Simulation;

/// <summary>Three numbers along three axes; what holds it says which axes. A plain value.</summary>
internal readonly struct Vector3(double first, double second, double third)
{
    public double First { get; } = first;

    public double Second { get; } = second;

    public double Third { get; } = third;
}
