using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Whether a rule is a finding: with the dwell of its condition, and of what ends it.</summary>
internal struct HealthRuleState
{
    private TimeSpan? _since;

    public bool IsFound { get; private set; }

    /// <summary>Updates it; called once in each evaluation.</summary>
    /// <param name="holds">Whether the condition holds now.</param>
    /// <param name="isClear">Whether what ends the finding holds now.</param>
    /// <param name="now">The time of the evaluation.</param>
    /// <param name="dwell">How long the condition holds before it is a finding.</param>
    /// <param name="clearDwell">How long the opposite holds before the finding ends.</param>
    public void Update(bool holds, bool isClear, TimeSpan now, TimeSpan dwell, TimeSpan clearDwell)
    {
        bool changes = IsFound ? isClear && !holds : holds;
        _since = changes ? _since ?? now : null;
        if (_since is not { } since || now - since < (IsFound ? clearDwell : dwell))
            return;
        IsFound = !IsFound;
        _since = null;
    }
}
