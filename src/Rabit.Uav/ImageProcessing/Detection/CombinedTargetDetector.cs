using System;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The default detector where classes are of more than one kind: markers, panels, templates, forms, colours. Each kind
/// has a detector of its own, which runs where one of its classes is wanted; a picture that one of them cannot search
/// is not searched. What a detector finds within what one before it has found is a part of that: the red half of a
/// panel in red and white is no red panel.
/// </summary>
/// <param name="parts">Those that know a thing best come first.</param>
internal sealed class CombinedTargetDetector(ImmutableArray<PartDetector> parts) : ITargetDetector
{
    private TargetDetection[] _found = [];
    private TargetDetection[] _kept = [];
    private ImmutableArray<TargetClass> _classes;

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        Prepare(input.Classes, detections.Length);
        (int count, int dropped, int kept) = (0, 0, 0);
        foreach (PartDetector part in parts)
        {
            if (!part.IsWanted)
                continue;
            DetectorResult result = part.Detector.Detect(input, _found);
            if (result.Refusal is not null)
                return result;
            dropped += result.Dropped;
            int before = kept;
            for (int i = 0; i < result.Count; i++)
            {
                ref readonly TargetDetection found = ref _found[i];
                if (!part.Has(found.Class) || IsWithin(found, _kept.AsSpan(0, before)))
                    continue;
                _kept[kept++] = found;
                DetectionOrder.Insert(found, detections, ref count, ref dropped);
            }
        }

        return DetectorResult.Found(count, dropped);
    }

    private void Prepare(ImmutableArray<TargetClass> classes, int most)
    {
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
    }

    private static bool IsWithin(in TargetDetection one, ReadOnlySpan<TargetDetection> others)
    {
        foreach (ref readonly TargetDetection other in others)
        {
            if (Math.Abs(one.CentreX - other.CentreX) <= other.WidthPixels / 2
                && Math.Abs(one.CentreY - other.CentreY) <= other.HeightPixels / 2)
                return true;
        }

        return false;
    }
}
