using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>A sort of thing on the ground.</summary>
internal sealed class TargetKind(
    string name, TargetClassName targetClass, SurfaceColour surface, double sideMetres, double widthMetres)
{
    public string Name { get; } = name;

    public TargetClassName Class { get; } = targetClass;

    public SurfaceColour Surface { get; } = surface;

    public double SideMetres { get; } = sideMetres;

    public double WidthMetres { get; } = widthMetres;
}
