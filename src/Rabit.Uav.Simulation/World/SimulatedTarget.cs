using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A flat rectangle that lies on the ground of the simulated world: a target of a mission, or a distractor, which
/// looks much like one and is none. Immutable.
/// </summary>
public sealed class SimulatedTarget
{
    /// <summary>Makes a thing whose values are set with it.</summary>
    public SimulatedTarget()
    {
    }

    private SimulatedTarget(SimulatedTarget other)
    {
        (Id, Name, Class, Declared, MarkerId) = (other.Id, other.Name, other.Class, other.Declared, other.MarkerId);
        (Position, Heading) = (other.Position, other.Heading);
        (SideMetres, WidthMetres) = (other.SideMetres, other.WidthMetres);
        (IsDistractor, IsPartlyHidden) = (other.IsDistractor, other.IsPartlyHidden);
        (Surface, Pattern) = (other.Surface, other.Pattern);
        (Motion, Route, RouteOffset, RouteStart) = (other.Motion, other.Route, other.RouteOffset, other.RouteStart);
    }

    /// <summary>Its number, from 1, targets first.</summary>
    public int Id { get; init; }

    /// <summary>What it is, one line for a person: "red panel 1", "rusty sheet 7".</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>
    /// Its class; <see cref="TargetClassName.None"/> for a distractor that has the colour of no class, but a near one.
    /// </summary>
    public TargetClassName Class { get; init; }

    /// <summary>
    /// Where its centre lies in the frame of the world, on the ground, at 0 down; of one that moves, at the start of
    /// the run.
    /// </summary>
    public NedPosition Position { get; init; }

    /// <summary>Its length along <see cref="Heading"/>, metres.</summary>
    /// <value>The default is 1: coloured panels are squares of 1 m.</value>
    public double SideMetres { get; init; } = 1;

    /// <summary>Its length across <see cref="Heading"/>, metres.</summary>
    /// <value>The default is 1.</value>
    public double WidthMetres { get; init; } = 1;

    /// <summary>Where its side points, clockwise from north.</summary>
    public Angle Heading { get; init; }

    /// <summary>Whether it is a distractor: a track of it that is confirmed is a false one.</summary>
    public bool IsDistractor { get; init; }

    /// <summary>How it moves.</summary>
    public SimulatedMotion Motion { get; init; }

    internal TargetRoute? Route { get; init; }

    // Of the frame and the clock in which the route is, to these here.
    private NedVector RouteOffset { get; init; }

    private TimeSpan RouteStart { get; init; }

    /// <summary>Which marker it is; null for what is none.</summary>
    public int? MarkerId { get; init; }

    /// <summary>Whether a part of it is overgrown.</summary>
    public bool IsPartlyHidden { get; init; }

    /// <summary>
    /// Its class, as a mission that searches for it may declare it; null where it is one of
    /// <see cref="TargetClass.Defaults"/>, or a distractor.
    /// </summary>
    public TargetClass? Declared { get; init; }

    internal SurfaceColour Surface { get; init; }

    /// <summary>What it looks like where it is not of one colour.</summary>
    internal SurfacePattern? Pattern { get; init; }

    /// <summary>Where its centre is at a time, in the frame of the world. Any thread.</summary>
    /// <param name="time">By the clock of the run; before the start it is where it is at the start.</param>
    public NedPosition PositionAt(TimeSpan time)
        => Route is null ? Position : Route.PositionAt(time + RouteStart) + RouteOffset;

    /// <summary>Its velocity at a time, m/s, in the frame of the world. Any thread.</summary>
    /// <param name="time">By the clock of the run.</param>
    public NedVector VelocityAt(TimeSpan time) => Route?.VelocityAt(time + RouteStart) ?? NedVector.Zero;

    internal SimulatedTarget With(SimulatedMotion motion, TargetRoute route)
        => new(this) { Position = route.PositionAt(TimeSpan.Zero), Motion = motion, Route = route };

    internal SimulatedTarget PartlyHidden(SurfacePattern pattern)
        => new(this) { IsPartlyHidden = true, Pattern = pattern };

    /// <summary>The same in another frame.</summary>
    /// <param name="position">Where it is at the start.</param>
    /// <param name="routeStart">How long it has moved at the beginning of the clock there.</param>
    internal SimulatedTarget At(NedPosition position, TimeSpan routeStart)
        => new(this) { Position = position, RouteOffset = position - Position, RouteStart = routeStart };
}
