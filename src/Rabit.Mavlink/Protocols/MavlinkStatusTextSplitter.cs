using System;
using Rabit.Mavlink.Definitions;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Cuts texts for people into STATUSTEXT messages of 50 bytes (MAVLink, STATUSTEXT: id and chunk_seq). One thread;
/// nothing is allocated.
/// </summary>
/// <remarks>
/// Texts are UTF-8; a character may be cut between two chunks, since only the last one may be shorter. Control
/// characters and halves of surrogate pairs become '?'. What is longer than the chunks hold is cut between two
/// characters.
/// </remarks>
/// <example>
/// <code>
/// static void Say(MavlinkStatusTextSplitter splitter, MavlinkSender sender, string text, Stream link, byte[] buffer)
/// {
///     splitter.Start(MavSeverity.Info, text);
///     while (splitter.TryNext(out Statustext chunk))
///         link.Write(buffer, 0, sender.Create(chunk).WriteTo(buffer));
/// }
/// </code>
/// </example>
public sealed class MavlinkStatusTextSplitter
{
    internal const int ChunkBytes = 50;
    private const int MaxOfProtocol = 256;

    private readonly byte[] _bytes;
    private readonly int _maxLength;
    private int _length;
    private int _chunk;
    private int _chunkCount;
    private ushort _lastId;
    private MavSeverity _severity;

    /// <summary>Makes a splitter.</summary>
    /// <param name="maxChunks">How many messages a text may take, 1 to 256.</param>
    /// <exception cref="ArgumentOutOfRangeException">Another number of chunks.</exception>
    public MavlinkStatusTextSplitter(int maxChunks = 4)
    {
        if (maxChunks is < 1 or > MaxOfProtocol)
            throw new ArgumentOutOfRangeException(nameof(maxChunks), maxChunks, "A text has 1 to 256 chunks.");

        // The last of several chunks ends with a zero; one alone need not.
        _maxLength = maxChunks == 1 ? ChunkBytes : (maxChunks * ChunkBytes) - 1;
        _bytes = new byte[maxChunks * ChunkBytes];
    }

    /// <summary>Whether the last text was too long and has been cut.</summary>
    public bool IsCut { get; private set; }

    /// <summary>Begins with another text.</summary>
    /// <param name="severity">How severe.</param>
    /// <param name="text">The text.</param>
    public void Start(MavSeverity severity, string text)
    {
        if (text is null)
            throw new ArgumentNullException(nameof(text));
        (_severity, _length, _chunk, IsCut) = (severity, 0, 0, false);
        Span<byte> character = stackalloc byte[Utf8Text.MaxBytesOfCharacter];
        for (int index = 0; index < text.Length;)
        {
            bool isControl = char.IsControl(text[index]);
            int length = Utf8Text.Write(text, ref index, character);
            if (length == 0)
                index++;
            if (length == 0 || isControl)
                (character[0], length) = ((byte)'?', 1);
            if (_length + length > _maxLength)
            {
                IsCut = true;
                break;
            }

            character.Slice(0, length).CopyTo(_bytes.AsSpan(_length));
            _length += length;
        }

        _chunkCount = _length <= ChunkBytes ? 1 : (_length / ChunkBytes) + 1;
        if (_chunkCount > 1)
            _lastId = _lastId == ushort.MaxValue ? (ushort)1 : (ushort)(_lastId + 1);
    }

    /// <summary>Takes the next chunk. Call it until there is none.</summary>
    /// <param name="chunk">The message.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryNext(out Statustext chunk)
    {
        chunk = default;
        if (_chunk >= _chunkCount)
            return false;
        int start = _chunk * ChunkBytes;
        chunk.Severity = _severity;
        chunk.Text = new Text50(_bytes.AsSpan(start, Math.Min(ChunkBytes, _length - start)));
        chunk.Id = _chunkCount > 1 ? _lastId : (ushort)0;
        chunk.ChunkSeq = (byte)_chunk++;
        return true;
    }
}
