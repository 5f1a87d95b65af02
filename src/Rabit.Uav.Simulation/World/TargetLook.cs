using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What a target of a kind is: its size, what it looks like, and the class that a mission may declare.
/// </summary>
internal sealed class TargetLook(
    string name, TargetClass declared, double sideMetres, double widthMetres, SurfacePattern pattern)
{
    public string Name { get; } = name;

    public TargetClass Declared { get; } = declared;

    public double SideMetres { get; } = sideMetres;

    public double WidthMetres { get; } = widthMetres;

    public SurfacePattern Pattern { get; } = pattern;

    /// <summary>Of a marker.</summary>
    public int? MarkerId { get; init; }
}
