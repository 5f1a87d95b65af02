using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The advice of the flight: of several at once the more severe. To return or to land is latched, since its reason may
/// only seem to be over; to hold ends with its reason.
/// </summary>
internal sealed class AdviceLatch
{
    private HealthFinding? _afterwards;
    private HealthAdvice _latched;
    private string? _latchedText;
    private HealthFinding? _holding;

    public HealthAdvice Advice { get; private set; }

    /// <summary>The reason, as text; null while there is none.</summary>
    public string? Text { get; private set; }

    /// <summary>Updates the advice with what was found.</summary>
    /// <param name="findings">All that is wrong now.</param>
    /// <param name="isFlying">Whether there is a mission in flight, which can be aborted.</param>
    public void Update(List<HealthFinding> findings, bool isFlying)
    {
        HealthFinding? hold = null;
        if (isFlying)
            Latch(findings, out hold);
        else
            _afterwards = null;
        Combine(hold);
    }

    private void Latch(List<HealthFinding> findings, out HealthFinding? hold)
    {
        hold = null;
        bool isStillThere = false;
        foreach (HealthFinding finding in findings)
        {
            if (finding.IsAdvisedAfterwards)
            {
                _afterwards = finding;
                isStillThere = true;
            }
            else if (finding.Advice > HealthAdvice.Hold)
            {
                Latch(finding);
            }
            else if (finding.Advice == HealthAdvice.Hold)
            {
                hold ??= finding;
            }
        }

        if (_afterwards is { } over && !isStillThere)
        {
            Latch(over);
            _afterwards = null;
        }
    }

    private void Latch(in HealthFinding finding)
    {
        if (finding.Advice <= _latched)
            return;
        _latched = finding.Advice;
        _latchedText = HealthText.Of(finding);
    }

    // The text is made only when it changes: otherwise nothing is allocated.
    private void Combine(in HealthFinding? hold)
    {
        bool holds = _latched < HealthAdvice.Hold && hold is not null;
        if (!holds)
        {
            (Advice, Text, _holding) = (_latched, _latchedText, null);
            return;
        }

        if (!hold.Equals(_holding))
            Text = HealthText.Of(hold!.Value);
        (Advice, _holding) = (HealthAdvice.Hold, hold);
    }
}
