using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The default detector where classes are of more than one kind: markers, panels, templates, colours, forms. Each kind
/// has a detector of its own, which runs where one of its classes is wanted; a picture that one of them cannot search
/// is not searched. What a detector finds within what one before it has found is a part of that: the red half of a
/// panel in red and white is no red panel. And what is of the colour of a much larger thing around it is a part of
/// that: the roof of a black car is no black panel. A form beside which the other colour of a panel of two lies is half
/// of that panel.
/// </summary>
/// <param name="parts">Those that know a thing best come first.</param>
internal sealed class CombinedTargetDetector(ImmutableArray<PartDetector> parts) : ITargetDetector
{
    // By their areas on the ground. In simulated flights a form that took ground of its hue in had up to 2.05 of the
    // area of the panel that it was; cars have 6 times that of what is of a panel's size on them.
    private const double MuchLarger = 2.5;

    // Of colours, the edge of what still counts as the same.
    private const double MinCloseness = 0.6;

    private readonly PanelHalf _half = new();
    private readonly TargetClass[] _twoColours =
        [.. parts.SelectMany(p => p.Classes).Where(c => c.SecondColour is not null)];

    private TargetDetection[] _found = [];
    private TargetDetection[] _kept = [];
    private TargetClass?[] _classOfKept = [];
    private int _keptCount;
    private ImmutableArray<TargetClass> _classes;

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        Prepare(input.Classes, detections.Length);
        (int count, int dropped) = (0, 0);
        foreach (PartDetector part in parts)
        {
            if (!part.IsWanted)
                continue;
            DetectorResult result = part.Detector.Detect(input, _found);
            if (result.Refusal is not null)
                return result;
            dropped += result.Dropped;
            Keep(part, result.Count, input);
        }

        for (int i = 0; i < _keptCount; i++)
        {
            if (_classOfKept[i] is not null)
                DetectionOrder.Insert(_kept[i], detections, ref count, ref dropped);
        }

        return DetectorResult.Found(count, dropped);
    }

    private void Prepare(ImmutableArray<TargetClass> classes, int most)
    {
        _keptCount = 0;
        if (_classes != classes)
        {
            _classes = classes;
            foreach (PartDetector part in parts)
                part.Select(_classes);
        }

        if (_found.Length == most)
            return;
        _found = new TargetDetection[most];
        _kept = new TargetDetection[most * parts.Length];
        _classOfKept = new TargetClass?[most * parts.Length];
    }

    private void Keep(PartDetector part, int count, in DetectorInput input)
    {
        int before = _keptCount;
        for (int i = 0; i < count; i++)
        {
            ref readonly TargetDetection found = ref _found[i];
            if (part.Find(found.Class) is not { } target || IsPart(found, before))
                continue;
            if (target is { Colour: not null, SecondColour: null } && TryCompletePanel(input, found, target))
                continue;
            for (int other = 0; other < before; other++)
            {
                if (_classOfKept[other] is { } own && IsPartOf(_kept[other], own, found, target))
                    _classOfKept[other] = null;
            }

            (_kept[_keptCount], _classOfKept[_keptCount]) = (found, target);
            _keptCount++;
        }
    }

    // A half of a panel is none of what it looks like; also of one that is not searched for.
    private bool TryCompletePanel(in DetectorInput input, in TargetDetection form, TargetClass formClass)
    {
        foreach (TargetClass panel in _twoColours)
        {
            if (!_half.TryComplete(input, form, formClass.Colour!, panel, out TargetDetection whole))
                continue;
            bool isKept = !IsWanted(panel);
            for (int i = 0; i < _keptCount; i++)
                isKept |= _classOfKept[i] == panel && IsWithin(whole, _kept[i]);
            if (isKept)
                return true;
            (_kept[_keptCount], _classOfKept[_keptCount]) = (whole, panel);
            _keptCount++;
            return true;
        }

        return false;
    }

    private bool IsWanted(TargetClass target)
    {
        foreach (TargetClass one in _classes)
        {
            if (one.Name == target.Name)
                return true;
        }

        return false;
    }

    // Of what detectors before it have found, but for what is small on it.
    private bool IsPart(in TargetDetection one, int before)
    {
        for (int i = 0; i < before; i++)
        {
            if (_classOfKept[i] is not null && IsWithin(one, _kept[i]) && !IsMuchLarger(one, _kept[i]))
                return true;
        }

        return false;
    }

    private static bool IsPartOf(
        in TargetDetection small, TargetClass smallClass, in TargetDetection large, TargetClass largeClass)
        => smallClass.SecondColour is null && largeClass.SecondColour is null
            && smallClass.Colour is { } one && largeClass.Colour is { } other && AreAlike(one, other)
            && IsWithin(small, large)
            && IsMuchLarger(large, small);

    // The box around a thing says little of it: a thread of ground that is joined to it makes that twice as large.
    private static bool IsMuchLarger(in TargetDetection large, in TargetDetection small)
        => large.SideMetres > 0 && small.SideMetres > 0
            ? large.SideMetres * large.SideMetres >= MuchLarger * small.SideMetres * small.SideMetres
            : large.WidthPixels * large.HeightPixels >= MuchLarger * small.WidthPixels * small.HeightPixels;

    internal static bool AreAlike(ColourRange one, ColourRange other)
        => PanelColours.IsNeutral(one) || PanelColours.IsNeutral(other)   // whose hue is noise
            ? (PanelColours.IsWhite(one) && PanelColours.IsWhite(other))
                || (PanelColours.IsBlack(one) && PanelColours.IsBlack(other))
            : one.Closeness(other.Red, other.Green, other.Blue) >= MinCloseness;

    private static bool IsWithin(in TargetDetection one, in TargetDetection other)
        => Math.Abs(one.CentreX - other.CentreX) <= other.WidthPixels / 2
            && Math.Abs(one.CentreY - other.CentreY) <= other.HeightPixels / 2;
}
