using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Says when the ground is told in words how we are, and makes the words: when the level or the advice has changed, not too often, in pieces
/// of 50 characters (STATUSTEXT).
/// </summary>
internal sealed class GroundTexts(TimeSpan period)
{
    private const int PieceLength = 50;
    private const int MaxPieces = 4;
    private const string Sender = "Rabit: ";

    private readonly List<Statustext> _pieces = [];
    private HealthLevel _toldLevel = HealthLevel.Good;
    private HealthAdvice _toldAdvice;
    private TimeSpan? _toldAt;
    private ushort _id;

    /// <summary>The pieces to send now; none where nothing is to be told. Good to the next call.</summary>
    public IReadOnlyList<Statustext> Take(in HealthReport report, TimeSpan now)
    {
        _pieces.Clear();
        bool isNews = report.Level != _toldLevel || report.Advice != _toldAdvice;
        if (!isNews || report.Level == HealthLevel.Unknown || (_toldAt is { } at && now - at < period))
            return _pieces;
        Cut(TextOf(report, isNewAdvice: report.Advice != _toldAdvice), SeverityOf(report.Level));
        _toldLevel = report.Level;
        _toldAdvice = report.Advice;
        _toldAt = now;
        return _pieces;
    }

    private static string TextOf(in HealthReport report, bool isNewAdvice)
    {
        string text = report.Text ?? "all well";
        return !isNewAdvice ? Sender + text
            : Sender + (report.Advice == HealthAdvice.Land ? "land! " : "go home! ") + report.AdviceText;
    }

    private static MavSeverity SeverityOf(HealthLevel level) => level switch
    {
        HealthLevel.Critical => MavSeverity.Critical,
        HealthLevel.Warning => MavSeverity.Warning,
        _ => MavSeverity.Info,
    };

    // A text of one piece has no id. The last of several pieces is shorter than the others, which ends the text.
    private void Cut(string text, MavSeverity severity)
    {
        if (text.Length >= MaxPieces * PieceLength)
            text = text.Substring(0, (MaxPieces * PieceLength) - 1);
        if (text.Length <= PieceLength)
        {
            Add(text, severity, id: 0, piece: 0);
            return;
        }

        _id = _id == ushort.MaxValue ? (ushort)1 : (ushort)(_id + 1);
        for (int piece = 0; piece * PieceLength <= text.Length; piece++)
        {
            int start = piece * PieceLength;
            Add(text.Substring(start, Math.Min(PieceLength, text.Length - start)), severity, _id, (byte)piece);
        }
    }

    private void Add(string text, MavSeverity severity, ushort id, byte piece)
        => _pieces.Add(new Statustext { Severity = severity, Text = new Text50(Plain(text)), Id = id, ChunkSeq = piece });

    private static string Plain(string text)
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
