using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>Cuts texts for ground stations into STATUSTEXT messages of 50 characters. For one thread.</summary>
internal sealed class StatusTextChunks
{
    private const int ChunkLength = 50;
    private const int MaxChunks = 4;

    private readonly List<Statustext> _chunks = [];
    private ushort _id;

    /// <summary>The chunks of a text; what is longer than four is cut off. Valid until the next call.</summary>
    /// <remarks>
    /// MAVLink, STATUSTEXT: a text of one chunk has no id; the last of several chunks is shorter than the others, which
    /// ends the text.
    /// </remarks>
    public IReadOnlyList<Statustext> Of(string text, MavSeverity severity)
    {
        _chunks.Clear();
        if (text.Length >= MaxChunks * ChunkLength)
            text = text.Substring(0, (MaxChunks * ChunkLength) - 1);
        if (text.Length <= ChunkLength)
        {
            Add(text, severity, id: 0, chunk: 0);
            return _chunks;
        }

        _id = _id == ushort.MaxValue ? (ushort)1 : (ushort)(_id + 1);
        for (int chunk = 0; chunk * ChunkLength <= text.Length; chunk++)
        {
            int start = chunk * ChunkLength;
            Add(text.Substring(start, Math.Min(ChunkLength, text.Length - start)), severity, _id, (byte)chunk);
        }

        return _chunks;
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
