using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The report.
public sealed partial class HealthManager
{
    private TimeSpan _lastPost;

    // The text is made only when a finding has changed: otherwise nothing is allocated.
    private void UpdateReport()
    {
        if (AreEqual(_findings, _lastFindings) && _next.Level != HealthLevel.Unknown)
            return;
        _next.Level = HealthLevel.Good;
        _next.Reasons = HealthReasons.None;
        foreach (HealthFinding finding in _findings)
        {
            _next.Reasons |= finding.Reason;
            if (finding.Level > _next.Level)
                _next.Level = finding.Level;
        }

        _next.Text = HealthText.Of(_findings);
        (_findings, _lastFindings) = (_lastFindings, _findings);
    }

    private static bool AreEqual(List<HealthFinding> a, List<HealthFinding> b)
    {
        if (a.Count != b.Count)
            return false;
        for (int i = 0; i < a.Count; i++)
        {
            if (!a[i].Equals(b[i]))
                return false;
        }

        return true;
    }

    // At once when it has changed, else once a second, so that its age shows that we are alive.
    private void PostReport(TimeSpan now)
    {
        ref HealthReport posted = ref _report.Value;
        bool isChanged = posted.Level != _next.Level
            || posted.Advice != _next.Advice
            || posted.SendsHeartbeat != _next.SendsHeartbeat
            || posted.HeartbeatsSent != _next.HeartbeatsSent
            || !ReferenceEquals(posted.Text, _next.Text);
        if (!isChanged && now - _lastPost < HeartbeatPeriod)
            return;
        posted = _next;
        _report.Post();
        _lastPost = now;
    }
}
