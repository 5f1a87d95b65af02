using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>Lays targets and distractors out on the ground of a simulated world, by a seed.</summary>
public static class TargetField
{
    /// <summary>How far the centre of anything is at least from the edge of the area, metres.</summary>
    public const double EdgeDistanceMetres = 4;

    /// <summary>How far the centres of any two things are at least from each other, metres.</summary>
    public const double MutualDistanceMetres = 12;

    // A thing that found no place so often is given up, and all of it begun again: the first ones may lie badly.
    private const int TriesPerThing = 500;
    private const int Attempts = 40;

    private const ulong PurposeOfPlaces = 0x706C616365;
    private const ulong PurposeOfAppearance = 0x6C6F6F6B73;
    private const ulong PurposeOfKinds = 0x6B696E6473;
    private const ulong PurposeOfCover = 0x636F766572;

    /// <summary>
    /// Lays out targets, squares of 1 m in each of the five colours in turn, and distractors: the same for the same
    /// seed, on every runtime.
    /// </summary>
    /// <param name="seed">Another seed, another layout.</param>
    /// <param name="area">
    /// Corners of the area in order, in the frame of the world; any winding, not crossing itself. Down is not read.
    /// </param>
    /// <param name="targets">How many targets, 0 or more.</param>
    /// <param name="distractors">
    /// How many distractors, 0 or more; those that find no place beside the targets are left out.
    /// </param>
    /// <returns>All things, targets first; the numbers begin at 1.</returns>
    /// <exception cref="ArgumentException">
    /// The area is none, a number is negative, or the targets do not fit into the area.
    /// </exception>
    public static IReadOnlyList<SimulatedTarget> Place(
        ulong seed, IReadOnlyList<NedPosition> area, int targets, int distractors)
    {
        var polygon = new GroundPolygon(area?.Select(c => (c.North, c.East)).ToArray()!, nameof(area));
        if (targets < 0 || distractors < 0)
        {
            throw new ArgumentOutOfRangeException(
                targets < 0 ? nameof(targets) : nameof(distractors),
                "The numbers of targets and distractors cannot be negative.");
        }

        List<(double North, double East)> places = FindPlaces(seed, polygon, targets, distractors);
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfAppearance));
        int firstPanel = random.Next(TargetKinds.Panels.Length);
        var things = new SimulatedTarget[places.Count];
        for (int i = 0; i < things.Length; i++)
        {
            bool isDistractor = i >= targets;
            TargetKind kind = isDistractor
                ? TargetKinds.Distractors[(i - targets) % TargetKinds.Distractors.Length]
                : TargetKinds.Panels[(firstPanel + i) % TargetKinds.Panels.Length];
            things[i] = Make(i + 1, kind, places[i], isDistractor, ref random);
        }

        return things;
    }

    /// <summary>
    /// As the other, where the targets are of several kinds: at the same places, beside the same distractors.
    /// </summary>
    /// <param name="seed">Another seed, another layout.</param>
    /// <param name="area">As of the other.</param>
    /// <param name="targets">As of the other.</param>
    /// <param name="distractors">As of the other.</param>
    /// <param name="kinds">What the targets are, in turn; none: coloured panels.</param>
    /// <param name="partlyHidden">
    /// How many of them, the first that are no markers, are overgrown by a fifth to two fifths.
    /// </param>
    /// <returns>All things, targets first; the numbers begin at 1.</returns>
    /// <exception cref="ArgumentException">
    /// As of the other; or there is no such kind, or <paramref name="partlyHidden"/> is negative.
    /// </exception>
    public static IReadOnlyList<SimulatedTarget> Place(
        ulong seed, IReadOnlyList<NedPosition> area, int targets, int distractors,
        IReadOnlyList<SimulatedTargetKind> kinds, int partlyHidden)
    {
        if (kinds is null)
            throw new ArgumentNullException(nameof(kinds));
        if (partlyHidden < 0)
            throw new ArgumentOutOfRangeException(
                nameof(partlyHidden), partlyHidden, "The number of hidden targets cannot be negative.");
        SimulatedTarget[] things = Place(seed, area, targets, distractors).ToArray();
        var numbers = new Dictionary<SimulatedTargetKind, int>();
        for (int i = 0; i < targets; i++)
        {
            SimulatedTargetKind kind = kinds.Count == 0 ? SimulatedTargetKind.ColouredPanel : kinds[i % kinds.Count];
            numbers.TryGetValue(kind, out int number);
            numbers[kind] = number + 1;
            if (kind != SimulatedTargetKind.ColouredPanel)
                things[i] = Make(things[i], TargetLooks.Of(kind, number, seed), seed);
            if (partlyHidden > 0 && things[i].MarkerId is null)
            {
                var cover = new SeededSequence(SeededSequence.Derive(seed, PurposeOfCover, (ulong)i));
                things[i] = things[i].PartlyHidden(
                    (things[i].Pattern ?? SurfacePattern.Of(things[i].Surface)).PartlyHidden(ref cover));
                partlyHidden--;
            }
        }

        return things;
    }

    private static SimulatedTarget Make(SimulatedTarget place, TargetLook look, ulong seed)
    {
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfKinds, (ulong)place.Id));
        return new SimulatedTarget
        {
            Id = place.Id,
            Name = look.Name + " " + place.Id.ToString(CultureInfo.InvariantCulture),
            Class = look.Declared.Name,
            Declared = look.Declared,
            Position = place.Position,
            SideMetres = look.SideMetres,
            WidthMetres = look.WidthMetres,
            Heading = place.Heading,
            MarkerId = look.MarkerId,
            Surface = look.Pattern.Main,
            Pattern = look.Pattern.Vary(ref random),
        };
    }

    private static SimulatedTarget Make(
        int id, TargetKind kind, (double North, double East) place, bool isDistractor, ref SeededSequence random)
    {
        return new SimulatedTarget
        {
            Id = id,
            Name = kind.Name + " " + id.ToString(CultureInfo.InvariantCulture),
            Class = kind.Class,
            Position = new NedPosition(place.North, place.East, 0),
            SideMetres = kind.SideMetres,
            WidthMetres = kind.WidthMetres,
            Heading = Angle.FromRadians(2 * Math.PI * random.NextUnit()),
            IsDistractor = isDistractor,
            Surface = kind.Surface.Vary(ref random),
        };
    }

    private static List<(double North, double East)> FindPlaces(
        ulong seed, GroundPolygon area, int targets, int distractors)
    {
        var random = new SeededSequence(SeededSequence.Derive(seed, PurposeOfPlaces));
        int count = targets + distractors;
        var most = new List<(double North, double East)>();
        for (int attempt = 0; attempt < Attempts; attempt++)
        {
            var places = new List<(double North, double East)>(count);
            while (places.Count < count && TryAdd(places, area, ref random))
            {
            }

            if (places.Count == count)
                return places;
            if (places.Count > most.Count)
                most = places;
        }

        if (most.Count >= targets)
            return most;

        string text = string.Format(
            CultureInfo.InvariantCulture,
            "{0} targets do not fit into the area, {1} m from its edge and {2} m from each other: only {3} found a "
                + "place.",
            targets, EdgeDistanceMetres, MutualDistanceMetres, most.Count);
        throw new ArgumentException(text, nameof(area));
    }

    private static bool TryAdd(List<(double North, double East)> places, GroundPolygon area, ref SeededSequence random)
    {
        for (int attempt = 0; attempt < TriesPerThing; attempt++)
        {
            double north = area.South + ((area.North - area.South) * random.NextUnit());
            double east = area.West + ((area.East - area.West) * random.NextUnit());
            if (area.Contains(north, east) && area.DistanceToEdge(north, east) >= EdgeDistanceMetres
                && IsFree(places, north, east))
            {
                places.Add((north, east));
                return true;
            }
        }

        return false;
    }

    private static bool IsFree(List<(double North, double East)> places, double north, double east)
    {
        foreach ((double otherNorth, double otherEast) in places)
        {
            (double dn, double de) = (north - otherNorth, east - otherEast);
            if ((dn * dn) + (de * de) < MutualDistanceMetres * MutualDistanceMetres)
                return false;
        }

        return true;
    }
}
