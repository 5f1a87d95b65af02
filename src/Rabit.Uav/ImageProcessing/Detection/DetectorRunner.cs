using System;
using Rabit.Core.Diagnostics;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Calls the detector, which may be the user's: measures its time, survives what it throws, and leaves out what is not
/// valid. Fixed memory; for the manager's thread.
/// </summary>
internal sealed class DetectorRunner(
    ITargetDetector detector, TimeSpan budget, int maxDetections, Func<TimeSpan> clock, bool keepsCut = false)
{
    public const string Failed = "the detector failed";
    private const string OverBudget = "the detector took longer than its time budget";

    private readonly TargetDetection[] _found = new TargetDetection[maxDetections];
    private int _count;

    /// <summary>The valid detections of the last picture, in the order of the detector.</summary>
    public ReadOnlySpan<TargetDetection> Found => new(_found, 0, _count);

    /// <summary>Detections of the last picture that had no room among those.</summary>
    public int Dropped { get; private set; }

    public long Failures { get; private set; }

    public long Refused { get; private set; }

    /// <summary>
    /// Detections that were left out since the border of the picture cuts them: a camera in flight sees them whole a
    /// moment later, and each may be a part of anything that is larger.
    /// </summary>
    public long Cut { get; private set; }

    public long Overruns { get; private set; }

    public string? LastFault { get; private set; }

    /// <summary>Searches a picture.</summary>
    /// <returns>Why it could not be searched; null if it was.</returns>
    public string? Run(in DetectorInput input)
    {
        (_count, Dropped) = (0, 0);
        TimeSpan begin = clock();
        DetectorResult result;
        try
        {
            result = detector.Detect(input, _found);
        }
        catch (Exception e)
        {
            // Whatever it is: a detector that fails may not end the flight, nor may its exception.
            return Fail($"the detector threw {ExceptionText.Describe(e)}");
        }

        if (clock() - begin > budget)
        {
            Overruns++;
            LastFault = OverBudget;
        }

        if (result.Refusal is not null)
            return result.Refusal;
        if (result.Count < 0 || result.Count > _found.Length || result.Dropped < 0)
            return Fail(FormattableString.Invariant(
                $"the detector returned {result.Count} detections, {result.Dropped} dropped; there was room for {_found.Length}"));
        Dropped = result.Dropped;
        KeepValid(input, result.Count);
        return null;
    }

    private void KeepValid(in DetectorInput input, int count)
    {
        for (int i = 0; i < count; i++)
        {
            if (DetectionCheck.FindFault(_found[i], input) is { } fault)
            {
                Refused++;
                LastFault = fault;
                continue;
            }

            if (_found[i].IsCut && !keepsCut)
            {
                Cut++;
                continue;
            }

            _found[_count++] = _found[i].IsCut ? CutTarget.Whole(_found[i], input) : _found[i];
        }
    }

    private string Fail(string fault)
    {
        Failures++;
        LastFault = fault;
        return Failed;
    }
}
