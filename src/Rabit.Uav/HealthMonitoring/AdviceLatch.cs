using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Keeps the gravest advice that was given in flight: it is not taken back, since what led to it may only seem to be over.
/// </summary>
internal sealed class AdviceLatch
{
    private HealthFinding? _afterwards;

    public HealthAdvice Advice { get; private set; }

    /// <summary>What led to it, for people; null while there is none.</summary>
    public string? Text { get; private set; }

    /// <summary>Takes what was found.</summary>
    /// <param name="findings">All that is wrong now.</param>
    /// <param name="isFlying">Whether there is a mission that can be given up.</param>
    public void Take(List<HealthFinding> findings, bool isFlying)
    {
        if (!isFlying)
        {
            _afterwards = null;
            return;
        }

        bool isStillThere = false;
        foreach (HealthFinding finding in findings)
        {
            if (!finding.IsAdvisedAfterwards)
            {
                Give(finding);
                continue;
            }

            _afterwards = finding;
            isStillThere = true;
        }

        if (_afterwards is { } over && !isStillThere)
        {
            Give(over);
            _afterwards = null;
        }
    }

    private void Give(in HealthFinding finding)
    {
        if (finding.Advice <= Advice)
            return;
        Advice = finding.Advice;
        Text = HealthText.Of(finding);
    }
}
