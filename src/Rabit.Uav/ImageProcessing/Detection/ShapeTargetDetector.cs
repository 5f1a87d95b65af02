using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The default detector for classes of one colour, of any size and form: panels, white ones among them, cars with their
/// windows, lying persons; also small, pale, shaded, overexposed and partly hidden ones, and such that the border of
/// the picture cuts. Pixels of a colour are joined to patches, each is measured below the size of a pixel against the
/// ground around it, and compared with every class of its colour, in metres. Fixed memory, no allocation after the
/// first picture; one thread at a time.
/// </summary>
/// <example>
/// White panels and red cars beside the default classes, in a picture of 640 x 480 from 40 m above, without the rest of
/// Image Processing:
/// <code>
/// ImmutableArray&lt;TargetClass&gt; classes =
/// [
///     .. TargetClass.Defaults,
///     new TargetClass("white") { Colour = new ColourRange(236, 236, 234) },
///     new TargetClass("red car")
///     {
///         Colour = new ColourRange(205, 28, 32), MinSideMetres = 2.4, MaxSideMetres = 3.7,
///         MinAspect = 1.7, MaxAspect = 2.8, MinColourShare = 0.7,
///     },
/// ];
/// var detector = new ShapeTargetDetector(classes);
/// var found = new TargetDetection[16];
/// var input = new DetectorInput(pixels, 640, 480, classes, PictureGroundScale.Uniform(0.075));
/// int count = detector.Detect(input, found).Count;
/// </code>
/// </example>
public sealed class ShapeTargetDetector : ITargetDetector
{
    /// <summary>How many classes it can distinguish.</summary>
    public const int MaxClasses = 64;

    internal const string TooManySpots = "the picture shows too many coloured spots to be searched";

    /// <summary>Side of the smallest panel that it finds, pixels.</summary>
    internal const double MinSidePixels = 4;

    // The least part of the side of the smallest target that is seen in its colour: the edge fades, and what is hidden
    // is not there. White does not fade.
    private const double MinSeenSide = 0.4;
    private const double MinSeenSideOfWhite = 0.6;
    private const double MinAreaPixels = 12;

    // How much larger than the largest target of its colour a patch may be, and which part of the box around it at
    // least is its own.
    private const double MaxSpan = 1.4;
    private const double MaxSeenArea = 1.3;
    private const double MinBoxShare = 0.15;

    // What has so many gaps in its rows that its runs are shorter than that is a texture.
    private const double MinRunLength = 2.2;
    private const int FewPixels = 30;

    // A colour further off is none of the class, whatever its form.
    private const double MaxColourCost = 8;

    // The cost at which a patch is as likely a target as not is the largest; by so much more, e times less likely.
    private const double CostScale = 3;

    // Of its side: how far around a part of a target the picture must reach.
    private const double AroundPart = 0.75;

    private readonly ImmutableArray<TargetClass> _classes;
    private readonly int[] _colourOf;
    private readonly SearchedColour[] _colours;
    private readonly PatchTable _table;
    private readonly PictureLight _light = new();
    private readonly PatchFinder _finder = new();
    private readonly PatchMeasure _measure = new();
    private readonly PatchBearing _bearing = new();
    private readonly PatchForm _form = new();
    private readonly PatchGroups _groups = new();
    private readonly PatchCandidates _candidates = new();
    private readonly WhiteReference _white = new();
    private readonly PixelAreas _areas = new();
    private readonly Patch[] _viable = new Patch[PatchFinder.MaxPatches];
    private readonly bool[] _isGrouped = new bool[PatchFinder.MaxPatches];
    private readonly PixelArray _pixels = new();

    /// <summary>Makes the detector.</summary>
    /// <param name="classes">
    /// All classes that it shall distinguish, each with a colour, also those that are not searched for. Classes of one
    /// colour must differ in size, aspect or shape.
    /// </param>
    /// <exception cref="ArgumentException">A class has no colour, or there are too many.</exception>
    public ShapeTargetDetector(ImmutableArray<TargetClass> classes)
    {
        string[] faults = TargetClass.FindFaults(classes).Concat(FindColourFaults(classes)).ToArray();
        if (faults.Length > 0)
            throw new ArgumentException("Shape detector: " + string.Join("; ", faults) + ".", nameof(classes));
        _classes = classes;
        var colours = new List<SearchedColour>();
        _colourOf = new int[classes.Length];
        for (int i = 0; i < classes.Length; i++)
        {
            _colourOf[i] = colours.FindIndex(c => c.IsSame(classes[i].Colour!));
            if (_colourOf[i] < 0)
            {
                _colourOf[i] = colours.Count;
                colours.Add(new SearchedColour(classes[i].Colour!));
            }

            colours[_colourOf[i]].Add(classes[i]);
        }

        _colours = colours.ToArray();
        _table = new PatchTable(colours.Select(c => c.Colour).ToArray());
    }

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (input.Format != PixelFormat.Rgb24)
            return DetectorResult.NotSearched(DetectorResult.NoColourPicture);
        byte[] pixels = _pixels.Of(input.Pixels);
        _light.Measure(pixels, input.Width, input.Height);
        if (!_finder.TryFind(pixels, input.Width, input.Height, _table, _light))
            return DetectorResult.NotSearched(TooManySpots);
        int count = KeepViable(input);
        _measure.SetPicture(pixels, input.Width, input.Height, _finder, _light);
        _candidates.Clear();
        _white.Clear(_light.Level);
        Array.Clear(_isGrouped, 0, count);
        for (int i = 0; i < count; i++)
            Consider(_viable.AsSpan(0, count), i, input.GroundScale);
        return Choose(input, detections);
    }

    internal static IEnumerable<string> FindColourFaults(ImmutableArray<TargetClass> classes)
    {
        if (classes.IsDefault)
            yield break;
        if (classes.Length > MaxClasses)
            yield return $"there are {classes.Length} target classes; the shape detector takes at most {MaxClasses}";
        foreach (TargetClass targetClass in classes.Where(c => c is not null && c.Colour is null))
            yield return $"target class {targetClass.Name} has no colour, which the shape detector needs";
        ColourRange[] colours =
        [
            .. classes.Select(c => c?.Colour).OfType<ColourRange>().GroupBy(c => (c.Red, c.Green, c.Blue))
                .Select(same => same.First()),
        ];
        if (PatchTable.FindFault(colours) is { } fault)
            yield return $"{fault}: {string.Join(", ", classes.Where(c => c?.Colour is not null).Select(c => c.Name))}";
    }

    // What costs least comes first: a meadow may have thousands of coloured spots.
    private int KeepViable(in DetectorInput input)
    {
        _areas.Measure(input);
        int count = 0;
        foreach (ref readonly Patch patch in _finder.Patches)
        {
            double least = MinSeenSideOf(patch.Colour);
            double largest = _areas.MaxAt(
                input.GroundScale, (patch.Left + patch.Right) / 2.0, (patch.Top + patch.Bottom) / 2.0);
            if (patch.Pixels * largest >= least * least)
                _viable[count++] = patch;
        }

        return count;
    }

    private double MinSeenSideOf(int colour)
        => _colours[colour].MinSideMetres * (_table.IsNeutral(colour) ? MinSeenSideOfWhite : MinSeenSide);

    private void Consider(ReadOnlySpan<Patch> patches, int first, in PictureGroundScale ground)
    {
        ref readonly Patch patch = ref patches[first];
        (int width, int height) = (patch.Right - patch.Left + 1, patch.Bottom - patch.Top + 1);
        if (patch.Pixels < MinBoxShare * width * height
            || (patch.Pixels > FewPixels && patch.Runs * MinRunLength > patch.Pixels)
            || !ground.TryAt(
                (patch.Left + patch.Right) / 2.0, (patch.Top + patch.Bottom) / 2.0, out GroundScale scale))
            return;
        double metres = Math.Sqrt(scale.PixelArea);
        SearchedColour colour = _colours[patch.Colour];
        double side = Math.Sqrt(patch.Pixels) * metres;
        if (side < MinSeenSideOf(patch.Colour)
            || side * side > MaxSeenArea * colour.MaxSideMetres * colour.MaxSideMetres
            || Math.Max(width, height) * metres > MaxSpan * colour.MaxSpanMetres)
            return;
        _groups.Take(patch);
        Measure(scale);
        if (colour.HasParts && !_isGrouped[first]
            && _groups.TryGrow(patches, first, colour.MaxSideMetres / metres, _isGrouped))
            Measure(scale);
    }

    private void Measure(in GroundScale scale)
    {
        ReadOnlySpan<Patch> parts = _groups.Parts;
        bool closesGaps = _colours[parts[0].Colour].HasParts;
        if (!_measure.TryLook(parts, closesGaps, out PatchShape shape)
            || _table.CostOf(shape, parts[0].Colour, _light, out double mixed) > MaxColourCost
            || !_measure.TryMeasure(ref shape) || shape.Area < MinAreaPixels)
            return;
        var best = new PatchCandidate
        {
            Cost = double.PositiveInfinity,
            Shape = shape,
            Parts = parts.Length,
            IsStrong = parts[0].IsStrong,
            Colour = parts[0].Colour,
            IsWhite = _table.IsWhite(parts[0].Colour),
        };
        var likeness = new ColourLikeness
        {
            Cost = _table.CostOf(shape, best.Colour, _light, out mixed),
            Darkness = _table.DarknessOf(shape, best.Colour),
            IsNeutral = _table.IsNeutral(best.Colour),
            PartOfWhite = _table.PartOfWhite(best.Colour),
            Mixed = mixed,
        };
        bool isShared = _colours[best.Colour].IsSharedWithPart;
        if (isShared)
            _measure.MeasureSurroundings(ref shape);
        _form.Clear();
        for (int i = 0; i < _classes.Length; i++)
        {
            if (_colourOf[i] != best.Colour)
                continue;
            double cost = PatchCost.Of(shape, scale, _classes[i], likeness, out double side, out double ofColour);
            if (isShared)
                cost += PatchCost.OfSurroundings(shape, _classes[i]);
            if (cost <= PatchCandidates.MaxCost)
                cost += _form.CostFor(ref shape, _classes[i], _measure);
            if (cost < best.Cost)
                (best.Cost, best.ColourCost, best.Class, best.SideMetres) = (cost, ofColour, i, side);
        }

        if (best.Cost <= PatchCandidates.MaxCost)
        {
            best.Bearing = _bearing.Of(shape, _classes[best.Class], scale, _measure);
            _measure.CorrectCentre(ref best.Shape);
        }

        if (best.IsWhite)
            _white.Add(shape, best.Cost);
        _candidates.Add(best);
    }

    private DetectorResult Choose(in DetectorInput input, Span<TargetDetection> detections)
    {
        // How bright white is in the picture is known once all of it was looked at.
        foreach (ref PatchCandidate one in _candidates.All)
            one.Cost += one.IsWhite ? _white.DarknessOf(one.Shape) : 0;
        _candidates.Rank();
        (int count, int dropped) = (0, _candidates.Dropped);
        for (int rank = 0; rank < _candidates.Count && _candidates[rank].Cost <= PatchCandidates.MaxCost; rank++)
        {
            ref readonly PatchCandidate candidate = ref _candidates[rank];
            if (_candidates.IsPiece(candidate) || !_candidates.TryChoose(rank)
                || !IsWanted(_classes[candidate.Class], input.Classes))
                continue;
            if (count == detections.Length)
                dropped++;
            else
                detections[count++] = Describe(candidate, input);
        }

        return DetectorResult.Found(count, dropped);
    }

    private TargetDetection Describe(in PatchCandidate candidate, in DetectorInput input) => new()
    {
        Class = _classes[candidate.Class].Name,
        CentreX = candidate.Shape.CentreX,
        CentreY = candidate.Shape.CentreY,
        WidthPixels = candidate.Shape.Width,
        HeightPixels = candidate.Shape.Height,
        SideMetres = candidate.SideMetres,
        IsCut = IsCut(candidate, input),
        Bearing = candidate.Bearing,
        Score = 1 / (1 + Math.Exp((candidate.Cost - PatchCandidates.MaxCost) / CostScale)),
        Covariance = PatchCovariance.Of(candidate.Shape, _classes[candidate.Class].MinColourShare < 1),
    };

    // A target with parts of other colours is known by one of them. Beside the border what lies around it is not seen:
    // the other half of a panel of two colours, or what else it may be a part of.
    private bool IsCut(in PatchCandidate candidate, in DetectorInput input)
    {
        ref readonly PatchShape shape = ref candidate.Shape;
        if (shape.TouchesBorder || _classes[candidate.Class].MinColourShare == 1)
            return shape.TouchesBorder;
        double around = AroundPart * Math.Sqrt(shape.Area);
        double across = (shape.Width / 2) + around;
        double down = (shape.Height / 2) + around;
        return shape.CentreX < across || shape.CentreX > input.Width - 1 - across
            || shape.CentreY < down || shape.CentreY > input.Height - 1 - down;
    }

    private static bool IsWanted(TargetClass target, ImmutableArray<TargetClass> wanted)
    {
        foreach (TargetClass one in wanted)
        {
            if (one.Name == target.Name)
                return true;
        }

        return false;
    }
}
