using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Decides when a STATUSTEXT about our health is sent to the ground station, and makes it: when the level or the advice
/// has changed, not too often, in chunks of 50 characters.
/// </summary>
internal sealed class StatusTextSender(TimeSpan period)
{
    private const string Sender = "Rabit: ";

    private readonly StatusTextChunks _chunks = new();
    private HealthLevel _sentLevel = HealthLevel.Good;
    private HealthAdvice _sentAdvice;
    private TimeSpan? _sentAt;

    /// <summary>The chunks to send now; none where there is nothing to report. Valid until the next call.</summary>
    public IReadOnlyList<Statustext> NextChunks(in HealthReport report, TimeSpan now)
    {
        bool isChanged = report.Level != _sentLevel || report.Advice != _sentAdvice;
        if (!isChanged || report.Level == HealthLevel.Unknown || (_sentAt is { } at && now - at < period))
            return [];
        string text = TextOf(report, isNewAdvice: report.Advice != _sentAdvice);
        _sentLevel = report.Level;
        _sentAdvice = report.Advice;
        _sentAt = now;
        return _chunks.Of(text, SeverityOf(report.Level));
    }

    private static string TextOf(in HealthReport report, bool isNewAdvice)
    {
        string text = report.Text ?? "all OK";
        return Sender + (!isNewAdvice ? text : report.Advice switch
        {
            HealthAdvice.Hold => "hold! " + report.AdviceText,
            HealthAdvice.ReturnToLaunch => "return to launch! " + report.AdviceText,
            HealthAdvice.Land => "land! " + report.AdviceText,
            _ => "no reason to hold any more; " + text,
        });
    }

    private static MavSeverity SeverityOf(HealthLevel level) => level switch
    {
        HealthLevel.Critical => MavSeverity.Critical,
        HealthLevel.Warning => MavSeverity.Warning,
        _ => MavSeverity.Info,
    };
}
