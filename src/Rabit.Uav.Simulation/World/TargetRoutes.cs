using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>Makes the ways of targets that move, by a seed, inside the area of the targets.</summary>
internal static class TargetRoutes
{
    // Half of what standing targets keep from the edge.
    private const double EdgeDistanceMetres = TargetField.EdgeDistanceMetres / 2;
    // At 8 m/s: a metre.
    private const double CheckEverySeconds = 0.125;
    private const int Tries = 1000;
    private const int Places = 8;
    private const double CourseSpeed = 8;
    private const ulong PurposeOfRoutes = 0x726F757465;

    /// <summary>The way of one target.</summary>
    /// <exception cref="ArgumentException">None fits into the area.</exception>
    public static TargetRoute Make(
        ulong seed, SimulatedTarget target, SimulatedMotion motion, IReadOnlyList<NedPosition> area)
    {
        var polygon = new GroundPolygon(area.Select(c => (c.North, c.East)).ToArray(), nameof(area));
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfRoutes, (ulong)target.Id));
        return motion switch
        {
            SimulatedMotion.Vehicle => Course(target, motion, polygon, (6, 3), ref random),
            SimulatedMotion.SteadyVehicle => Course(target, motion, polygon, (25, CourseSpeed), ref random),
            _ => Wander(target, motion, polygon, ref random),
        };
    }

    // From place to place and back to the first, with a stop at each.
    private static TargetRoute Wander(
        SimulatedTarget target, SimulatedMotion motion, GroundPolygon area, ref SeededSequence random)
    {
        bool isWalking = motion == SimulatedMotion.Walking;
        (double leastWay, double mostWay) = isWalking ? (8.0, 30.0) : (3.0, 15.0);
        var legs = new List<RouteLeg>();
        NedPosition at = target.Position;
        for (int attempt = 0; attempt < Tries && legs.Count < Places; attempt++)
        {
            double heading = 2 * Math.PI * random.NextUnit();
            double way = leastWay + ((mostWay - leastWay) * random.NextUnit());
            NedPosition next = legs.Count == Places - 1
                ? target.Position
                : at + new NedVector(way * Trig.Cos(heading), way * Trig.Sin(heading), 0);
            RouteLeg? leg = Straight(at, next, isWalking, ref random);
            bool canReturn = legs.Count < Places - 2 || (legs.Count == Places - 1)
                || IsInside(area, Straight(next, target.Position, isWalking, ref random));
            if (leg is null || !IsInside(area, leg) || !canReturn)
                continue;
            legs.Add(leg);
            at = next;
        }

        return legs.Count == Places ? new TargetRoute(legs) : throw NoRoom(target, motion);
    }

    private static RouteLeg? Straight(NedPosition from, NedPosition to, bool isWalking, ref SeededSequence random)
    {
        (double top, double acceleration, double pause) = isWalking
            ? (1.4 * (1 + (0.1 * random.NextSigned())), 0.8, 3 + (12 * random.NextUnit()))
            : (0.5 + (2.5 * random.NextUnit()), 2, random.NextUnit());
        NedVector way = to - from;
        double length = Math.Sqrt((way.North * way.North) + (way.East * way.East));
        return length < 0.5
            ? null
            : new RouteLeg(
                from, Math.Atan2(way.East, way.North), 0, length, (0, top, 0), acceleration, pause);
    }

    // A rectangle with round corners, begun in the middle of a side; smaller as tries fail, and elsewhere where the
    // target lies too near to a corner of the area for any.
    private static TargetRoute Course(
        SimulatedTarget target, SimulatedMotion motion, GroundPolygon area,
        (double RadiusMetres, double MetresPerSecond) curve, ref SeededSequence random)
    {
        for (int attempt = 0; attempt < Tries; attempt++)
        {
            double scale = 1 - (attempt / (double)Tries);
            NedPosition start = attempt < Tries / 2
                ? target.Position
                : new NedPosition(
                    area.South + ((area.North - area.South) * random.NextUnit()),
                    area.West + ((area.East - area.West) * random.NextUnit()), 0);
            double heading = 2 * Math.PI * random.NextUnit();
            double turn = random.NextSigned() < 0 ? -1 : 1;
            double side = 6 + (74 * scale * random.NextUnit());
            double width = 6 + (44 * scale * random.NextUnit());
            List<RouteLeg> legs = Rectangle(start, heading, turn, (side, width), curve);
            if (legs.TrueForAll(l => IsInside(area, l)))
                return new TargetRoute(legs);
        }

        throw NoRoom(target, motion);
    }

    private static List<RouteLeg> Rectangle(
        NedPosition start, double heading, double turn, (double Side, double Width) metres,
        (double RadiusMetres, double MetresPerSecond) curve)
    {
        const double Acceleration = 2;
        var legs = new List<RouteLeg>();
        NedPosition at = start;
        double[] straights = [metres.Side / 2, metres.Width, metres.Side, metres.Width, metres.Side / 2];
        (double radius, double slow) = curve;
        for (int i = 0; i < straights.Length; i++)
        {
            // The side that is begun in its middle is passed at the speed of the curves there.
            legs.Add(new RouteLeg(at, heading, 0, straights[i], (slow, CourseSpeed, slow), Acceleration, 0));
            at = legs[legs.Count - 1].PositionAt(legs[legs.Count - 1].Seconds);
            if (i == straights.Length - 1)
                break;
            legs.Add(new RouteLeg(
                at, heading, turn / radius, radius * Math.PI / 2, (slow, slow, slow), Acceleration, 0));
            at = legs[legs.Count - 1].PositionAt(legs[legs.Count - 1].Seconds);
            heading += turn * Math.PI / 2;
        }

        return legs;
    }

    private static bool IsInside(GroundPolygon area, RouteLeg? leg)
    {
        if (leg is null)
            return false;
        for (double seconds = 0; seconds < leg.Seconds; seconds += CheckEverySeconds)
        {
            if (!IsInside(area, leg.PositionAt(seconds)))
                return false;
        }

        return IsInside(area, leg.PositionAt(leg.Seconds));
    }

    private static bool IsInside(GroundPolygon area, NedPosition place)
        => area.Contains(place.North, place.East)
            && area.DistanceToEdge(place.North, place.East) >= EdgeDistanceMetres;

    private static ArgumentException NoRoom(SimulatedTarget target, SimulatedMotion motion)
        => new(string.Format(
            CultureInfo.InvariantCulture,
            "The area has no room for a way of '{0}' ({1}), {2} m from its edge.",
            target.Name, motion, EdgeDistanceMetres), nameof(target));
}
