using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Latches the most severe advice that was given in flight: it is not withdrawn, since its reason may only seem to be
/// over.
/// </summary>
internal sealed class AdviceLatch
{
    private HealthFinding? _afterwards;

    public HealthAdvice Advice { get; private set; }

    /// <summary>The reason, as text; null while there is none.</summary>
    public string? Text { get; private set; }

    /// <summary>Updates the advice with what was found.</summary>
    /// <param name="findings">All that is wrong now.</param>
    /// <param name="isFlying">Whether there is a mission in flight, which can be aborted.</param>
    public void Update(List<HealthFinding> findings, bool isFlying)
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
                Latch(finding);
                continue;
            }

            _afterwards = finding;
            isStillThere = true;
        }

        if (_afterwards is { } over && !isStillThere)
        {
            Latch(over);
            _afterwards = null;
        }
    }

    private void Latch(in HealthFinding finding)
    {
        if (finding.Advice <= Advice)
            return;
        Advice = finding.Advice;
        Text = HealthText.Of(finding);
    }
}
