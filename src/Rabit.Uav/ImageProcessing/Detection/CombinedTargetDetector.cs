using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The default detector where there are markers among the classes: they, and what has a colour.</summary>
internal sealed class CombinedTargetDetector(ITargetDetector colours, ITargetDetector markers) : ITargetDetector
{
    private TargetDetection[] _second = [];
    private ImmutableArray<TargetClass> _classes;
    private bool _hasColours;
    private bool _hasMarkers;

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (_classes != input.Classes)
            Change(input.Classes);
        if (!_hasMarkers)
            return colours.Detect(input, detections);
        if (!_hasColours)
            return markers.Detect(input, detections);
        DetectorResult first = colours.Detect(input, detections);
        if (first.Refusal is not null)
            return first;
        if (_second.Length != detections.Length)
            _second = new TargetDetection[detections.Length];
        DetectorResult second = markers.Detect(input, _second);
        if (second.Refusal is not null)
            return second;
        (int count, int dropped) = (first.Count, first.Dropped + second.Dropped);
        for (int i = 0; i < second.Count; i++)
            DetectionOrder.Insert(_second[i], detections, ref count, ref dropped);
        return DetectorResult.Found(count, dropped);
    }

    // A method of its own, so that only a change allocates for the lambdas.
    private void Change(ImmutableArray<TargetClass> classes)
    {
        _classes = classes;
        _hasMarkers = classes.Any(c => c.Marker is not null);
        _hasColours = classes.Any(c => c.Marker is null);
    }
}
