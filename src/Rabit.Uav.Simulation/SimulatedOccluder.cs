using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Something in the simulated world that targets go below, where the camera does not see them. It is painted over all
/// that lies on the ground, at the ground: no target leans out of below it when it is seen from the side. Immutable.
/// </summary>
public sealed record SimulatedOccluder
{
    /// <summary>What it is.</summary>
    /// <value>The default is <see cref="SimulatedOccluderKind.Tree"/>.</value>
    public SimulatedOccluderKind Kind { get; init; }

    /// <summary>Its middle, in the frame of the world; down is not read.</summary>
    public NedPosition Position { get; init; }

    /// <summary>Its length along <see cref="Heading"/>, metres, 1 to 200.</summary>
    /// <value>The default is 8.</value>
    public double LengthMetres { get; init; } = 8;

    /// <summary>Its width across <see cref="Heading"/>, metres, 1 to 200.</summary>
    /// <value>The default is 8.</value>
    public double WidthMetres { get; init; } = 8;

    /// <summary>Where its length points, clockwise from north.</summary>
    public Angle Heading { get; init; }

    /// <summary>
    /// Whether it hides a place on the ground: below a tree, whose edge is ragged, as if that were an ellipse. Any
    /// thread.
    /// </summary>
    /// <param name="place">In the frame of the world; down is not read.</param>
    public bool Hides(NedPosition place)
    {
        (double sin, double cos) = (Trig.Sin(Heading.Radians), Trig.Cos(Heading.Radians));
        (double north, double east) = (place.North - Position.North, place.East - Position.East);
        double along = 2 * ((north * cos) + (east * sin)) / LengthMetres;
        double across = 2 * ((east * cos) - (north * sin)) / WidthMetres;
        return Kind == SimulatedOccluderKind.Tree
            ? (along * along) + (across * across) <= 1
            : Math.Abs(along) <= 1 && Math.Abs(across) <= 1;
    }

    /// <summary>What is wrong with it; null for nothing.</summary>
    internal string? FindFault()
    {
        if (Kind is not (SimulatedOccluderKind.Tree or SimulatedOccluderKind.Roof))
            return $"{nameof(Kind)} is {Kind}; there is none of that number";
        if (!(LengthMetres is >= 1 and <= 200) || !(WidthMetres is >= 1 and <= 200))
            return FormattableString.Invariant($"it is {LengthMetres} by {WidthMetres} m; it must be 1 to 200 m");
        bool isNear = Math.Abs(Position.North) < 1e6 && Math.Abs(Position.East) < 1e6;
        return isNear && Math.Abs(Heading.Radians) <= 2 * Math.PI
            ? null
            : $"{nameof(Position)} and {nameof(Heading)} must be a place near home and an angle of at most one turn";
    }
}
