using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>A real target: its class and where it is. Immutable.</summary>
/// <param name="name">For people.</param>
/// <param name="targetClass">The class.</param>
/// <param name="position">The centre; the altitude is not used.</param>
public sealed class TruthTarget(string name, TargetClassName targetClass, GeodeticPosition position)
{
    /// <summary>For people.</summary>
    public string Name { get; } = name ?? throw new ArgumentNullException(nameof(name));

    /// <summary>The class.</summary>
    public TargetClassName Class { get; } = targetClass;

    /// <summary>The centre; the altitude is not used.</summary>
    public GeodeticPosition Position { get; } = position;
}
