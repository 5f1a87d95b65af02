namespace Rabit.Uav.Simulation;

/// <summary>What a <see cref="SimulatedOccluder"/> looks like.</summary>
public enum SimulatedOccluderKind
{
    /// <summary>The round crown of a tree, of ragged edge.</summary>
    Tree,

    /// <summary>A roof, a rectangle.</summary>
    Roof,
}
