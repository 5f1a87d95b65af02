namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>What keeps the drawn targets of a picture from being seen as they are.</summary>
public enum PartialKind
{
    Clear,
    Hidden,
    Cut,
    Clipped,
}
