namespace Rabit.Benchmarks.Core;

/// <summary>An immutable message.</summary>
internal sealed class RouteNote(int legs)
{
    public int Legs { get; } = legs;
}
