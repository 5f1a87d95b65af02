using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Finds out by how much the times of the pictures are off those of the poses: targets that are seen at different
/// velocities are reported at different places, by velocity times offset. For one thread.
/// </summary>
internal sealed class CameraClockMonitor
{
    // The newest ones count: some ten targets, in both directions and revisited.
    private const int MaxPasses = 80;

    // Several targets in one picture have a pass each; the newest passes are the open ones.
    private const int MaxOpen = 20;

    // The fit makes the guess better by what its steps are; where it goes elsewhere, something is not understood.
    private const double MaxFromGuess = 0.2;

    private readonly List<TargetPass> _passes = new(MaxPasses);
    private readonly CameraClockVote _vote = new();
    private readonly CameraClockFit _fit = new();
    private bool _hasNewPass;

    /// <summary>The estimate.</summary>
    public CameraClockEstimate Estimate { get; private set; }

    /// <summary>Forgets everything: places are in another frame from now on.</summary>
    public void Clear()
    {
        _passes.Clear();
        Estimate = default;
    }

    /// <summary>Takes a report of our own camera.</summary>
    public void Add(in LocatedReport report)
    {
        if (!report.IsOwn || report.Report.Sensitivity is null)
            return;
        for (int i = _passes.Count - 1; i >= 0 && i >= _passes.Count - MaxOpen; i--)
        {
            if (_passes[i].TryAdd(report))
                return;
        }

        TargetPass pass = _passes.Count < MaxPasses ? new TargetPass() : _passes[0];
        if (_passes.Count == MaxPasses)
            _passes.RemoveAt(0);
        pass.Begin(report);
        _passes.Add(pass);
        _hasNewPass = true;
    }

    /// <summary>Estimates again where a pass was begun since the last time: those before it are complete.</summary>
    /// <returns>Whether it did.</returns>
    public bool Update()
    {
        if (!_hasNewPass)
            return false;
        _hasNewPass = false;
        Estimate = _vote.TryFind(_passes, out double guess) ? _fit.Fit(_passes, guess) : default;
        if (Math.Abs(Estimate.OffsetSeconds - guess) > MaxFromGuess)
            Estimate = default;
        return true;
    }
}
