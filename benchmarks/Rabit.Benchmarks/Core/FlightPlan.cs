namespace Rabit.Benchmarks.Core;

/// <summary>An immutable message.</summary>
internal sealed class FlightPlan(int legs)
{
    public int Legs { get; } = legs;
}
