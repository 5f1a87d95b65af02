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

    /// <summary>The centre, of one that moves at the start of the run; the altitude is not used.</summary>
    public GeodeticPosition Position { get; } = position;

    /// <summary>Where it is at a time, by the clock of the run; null where it stands.</summary>
    internal Func<TimeSpan, GeodeticPosition>? Way { get; init; }

    /// <summary>Where its centre is at a time; the altitude is not used.</summary>
    /// <param name="time">By the clock of the run.</param>
    public GeodeticPosition PositionAt(TimeSpan time) => Way?.Invoke(time) ?? Position;
}
