using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.ImageProcessing;

namespace VisionBench;

/// <summary>The detections of one picture against its truth.</summary>
internal sealed class FrameScore
{
    private readonly List<TargetMatch> _matches = [];
    private readonly List<FalseAlarm> _falseAlarms = [];

    /// <summary>Compares. A detection of a target that does not count, or of a marker, is ignored.</summary>
    public FrameScore(ListedFrame frame, ReadOnlySpan<TargetDetection> detections, bool isColourEnough)
    {
        Frame = frame;
        var matchOf = new TargetMatch?[detections.Length];
        foreach (ListedTarget target in frame.Targets.Where(t => t.Counts))
        {
            var match = new TargetMatch(target);
            for (int i = 0; i < detections.Length; i++)
            {
                if (matchOf[i] is null && match.Found is null
                    && target.Matches(detections[i].CentreX, detections[i].CentreY)
                    && IsRight(target, detections[i], isColourEnough))
                    (matchOf[i], match.Found) = (match, detections[i]);
            }

            _matches.Add(match);
        }

        for (int i = 0; i < detections.Length; i++)
        {
            if (matchOf[i] is null)
                NoteOther(detections[i], isColourEnough);
        }
    }

    public ListedFrame Frame { get; }

    /// <summary>One for each target that counts.</summary>
    public IReadOnlyList<TargetMatch> Matches => _matches;

    public IReadOnlyList<FalseAlarm> FalseAlarms => _falseAlarms;

    /// <summary>Its markers, which are searched for by themselves.</summary>
    public MarkerScore? Markers { get; set; }

    /// <summary>Detections of a target that had one of the right class already.</summary>
    public int Duplicates { get; private set; }

    // On a target that counts, it is one of a wrong class or in a wrong place; or one too many.
    private void NoteOther(in TargetDetection detection, bool isColourEnough)
    {
        (double x, double y) = (detection.CentreX, detection.CentreY);
        foreach (TargetMatch match in _matches)
        {
            if (!match.Target.Matches(x, y) && !match.Target.Covers(x, y))
                continue;
            if (match.Found is not null && IsRight(match.Target, detection, isColourEnough))
                Duplicates++;
            else
                _falseAlarms.Add(new FalseAlarm(detection, $"{match.Target.Class} {match.Target.Size:0.0} px"));
            return;
        }

        if (Frame.Targets.Any(t => !t.Counts && (t.Matches(x, y) || t.Covers(x, y))))
            return;
        ListedDistractor? on = Frame.Distractors.Where(d => d.Covers(x, y)).OrderBy(d => d.Size).FirstOrDefault();
        _falseAlarms.Add(new FalseAlarm(detection, on?.Kind ?? "ground"));
    }

    private static bool IsRight(ListedTarget target, in TargetDetection detection, bool isColourEnough)
    {
        string name = detection.Class.ToString();
        return string.Equals(name, target.Class, StringComparison.Ordinal)
            || (isColourEnough && BenchClasses.ColourOf(name) == target.Colour);
    }
}
