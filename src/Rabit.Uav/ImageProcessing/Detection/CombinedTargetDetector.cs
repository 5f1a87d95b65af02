using System;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The default detector where classes are of more than one kind: coloured, markers, templates. Each kind has a detector
/// of its own, which runs where one of its classes is wanted; a picture that one of them cannot search is not searched.
/// </summary>
internal sealed class CombinedTargetDetector(ImmutableArray<PartDetector> parts) : ITargetDetector
{
    private TargetDetection[] _found = [];
    private ImmutableArray<TargetClass> _classes;

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (_classes != input.Classes)
        {
            _classes = input.Classes;
            foreach (PartDetector part in parts)
                part.Select(_classes);
        }

        if (_found.Length != detections.Length)
            _found = new TargetDetection[detections.Length];
        (int count, int dropped) = (0, 0);
        foreach (PartDetector part in parts)
        {
            if (!part.IsWanted)
                continue;
            DetectorResult result = part.Detector.Detect(input, _found);
            if (result.Refusal is not null)
                return result;
            dropped += result.Dropped;
            for (int i = 0; i < result.Count; i++)
                DetectionOrder.Insert(_found[i], detections, ref count, ref dropped);
        }

        return DetectorResult.Found(count, dropped);
    }
}
