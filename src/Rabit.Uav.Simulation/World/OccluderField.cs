using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Places trees and roofs by a seed: over the ways of the targets that move, in turn, or anywhere where none moves.
/// They hide nothing that stands. Those that find no place are left out.
/// </summary>
internal static class OccluderField
{
    private const int Tries = 500;

    // Between an edge and what must not be hidden, or another one.
    private const double MarginMetres = 2;

    private const ulong PurposeOfOccluders = 0x6F63636C7564;
    private const ulong PurposeOfLooks = 0x63726F776E;

    // Nominal colours of crowns and of tiles, none near to that of a target.
    private static readonly SurfaceColour[] Leaves = [new(52, 74, 38), new(66, 90, 46), new(40, 58, 32)];
    private static readonly SurfaceColour Tiles = new(104, 92, 86);

    public static IReadOnlyList<SimulatedOccluder> Place(
        ulong seed, IReadOnlyList<NedPosition> area, IReadOnlyList<SimulatedTarget> things, int count)
    {
        var polygon = new GroundPolygon(area.Select(c => (c.North, c.East)).ToArray(), nameof(area));
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfOccluders));
        TargetRoute[] routes = things.Where(t => t.Route is not null).Select(t => t.Route!).ToArray();
        SimulatedTarget[] standing = things.Where(t => t.Route is null).ToArray();
        var placed = new List<SimulatedOccluder>();
        for (int i = 0; i < count; i++)
        {
            for (int attempt = 0; attempt < Tries; attempt++)
            {
                SimulatedOccluder one = Draft(
                    i % 2 == 0 ? SimulatedOccluderKind.Tree : SimulatedOccluderKind.Roof,
                    routes.Length == 0 ? Anywhere(polygon, ref random) : On(routes[i % routes.Length], ref random),
                    ref random);
                if (!IsFree(one, standing, placed))
                    continue;
                placed.Add(one);
                break;
            }
        }

        return placed;
    }

    /// <summary>As the camera sees it.</summary>
    /// <param name="occluder">What it is.</param>
    /// <param name="number">From 0; another one looks a little different.</param>
    /// <param name="seed">Of the world.</param>
    public static SimulatedTarget SheetOf(SimulatedOccluder occluder, int number, ulong seed)
    {
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfLooks, (ulong)number));
        return new SimulatedTarget
        {
            Name = occluder.Kind == SimulatedOccluderKind.Tree ? "tree" : "roof",
            Position = occluder.Position with { Down = 0 },
            SideMetres = occluder.LengthMetres,
            WidthMetres = occluder.WidthMetres,
            Heading = occluder.Heading,
            IsDistractor = true,
            Surface = Tiles.Vary(ref random),
            Pattern = occluder.Kind == SimulatedOccluderKind.Tree ? Crown(ref random) : null,
        };
    }

    private static SurfacePattern Crown(ref SeededSequence random)
    {
        const int Side = 24;
        byte[] cells = new byte[Side * Side];
        for (int i = 0; i < cells.Length; i++)
        {
            (double x, double y) = ((i % Side) - ((Side - 1) / 2.0), (i / Side) - ((Side - 1) / 2.0));
            double edge = (Side / 2.0) - (1.5 * random.NextUnit());
            int leaf = random.Next(Leaves.Length);
            cells[i] = (x * x) + (y * y) <= edge * edge ? (byte)leaf : SurfacePattern.Open;
        }

        return new SurfacePattern(Side, Side, cells, Leaves).Vary(ref random);
    }

    private static SimulatedOccluder Draft(SimulatedOccluderKind kind, NedPosition at, ref SeededSequence random)
    {
        double length = 6 + (6 * random.NextUnit());
        double width = kind == SimulatedOccluderKind.Tree ? length : 5 + (4 * random.NextUnit());
        return new SimulatedOccluder
        {
            Kind = kind,
            Position = at,
            LengthMetres = length,
            WidthMetres = width,
            Heading = Angle.FromRadians(2 * Math.PI * random.NextUnit()),
        };
    }

    private static NedPosition On(TargetRoute route, ref SeededSequence random)
        => route.PositionAt(TimeSpan.OfSeconds(route.PeriodSeconds * random.NextUnit()));

    private static NedPosition Anywhere(GroundPolygon area, ref SeededSequence random)
    {
        while (true)
        {
            double north = area.South + ((area.North - area.South) * random.NextUnit());
            double east = area.West + ((area.East - area.West) * random.NextUnit());
            if (area.Contains(north, east))
                return new NedPosition(north, east, 0);
        }
    }

    private static bool IsFree(SimulatedOccluder one, SimulatedTarget[] standing, List<SimulatedOccluder> others)
        => Array.TrueForAll(
                standing, t => Distance(one.Position, t.Position) >= Reach(one) + (t.SideMetres / 2) + MarginMetres)
            && others.TrueForAll(
                o => Distance(one.Position, o.Position) >= Reach(one) + Reach(o) + MarginMetres);

    private static double Reach(SimulatedOccluder one)
        => 0.5 * Math.Sqrt((one.LengthMetres * one.LengthMetres) + (one.WidthMetres * one.WidthMetres));

    private static double Distance(NedPosition a, NedPosition b)
        => Math.Sqrt(((a.North - b.North) * (a.North - b.North)) + ((a.East - b.East) * (a.East - b.East)));
}
