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
    private const int ChunkLength = 50;
    private const int MaxChunks = 4;
    private const string Sender = "Rabit: ";

    private readonly List<Statustext> _chunks = [];
    private HealthLevel _sentLevel = HealthLevel.Good;
    private HealthAdvice _sentAdvice;
    private TimeSpan? _sentAt;
    private ushort _id;

    /// <summary>The chunks to send now; none where there is nothing to report. Valid until the next call.</summary>
    public IReadOnlyList<Statustext> NextChunks(in HealthReport report, TimeSpan now)
    {
        _chunks.Clear();
        bool isChanged = report.Level != _sentLevel || report.Advice != _sentAdvice;
        if (!isChanged || report.Level == HealthLevel.Unknown || (_sentAt is { } at && now - at < period))
            return _chunks;
        Cut(TextOf(report, isNewAdvice: report.Advice != _sentAdvice), SeverityOf(report.Level));
        _sentLevel = report.Level;
        _sentAdvice = report.Advice;
        _sentAt = now;
        return _chunks;
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

    // MAVLink, STATUSTEXT: a text of one chunk has no id; the last of several chunks is shorter than the others, which
    // ends the text.
    private void Cut(string text, MavSeverity severity)
    {
        if (text.Length >= MaxChunks * ChunkLength)
            text = text.Substring(0, (MaxChunks * ChunkLength) - 1);
        if (text.Length <= ChunkLength)
        {
            Add(text, severity, id: 0, chunk: 0);
            return;
        }

        _id = _id == ushort.MaxValue ? (ushort)1 : (ushort)(_id + 1);
        for (int chunk = 0; chunk * ChunkLength <= text.Length; chunk++)
        {
            int start = chunk * ChunkLength;
            Add(text.Substring(start, Math.Min(ChunkLength, text.Length - start)), severity, _id, (byte)chunk);
        }
    }

    private void Add(string text, MavSeverity severity, ushort id, byte chunk)
        => _chunks.Add(
            new Statustext { Severity = severity, Text = new Text50(ToAscii(text)), Id = id, ChunkSeq = chunk });

    private static string ToAscii(string text)
    {
        char[] characters = text.ToCharArray();
        for (int i = 0; i < characters.Length; i++)
        {
            if (characters[i] is < ' ' or > '~')
                characters[i] = '?';
        }

        return new string(characters);
    }
}
