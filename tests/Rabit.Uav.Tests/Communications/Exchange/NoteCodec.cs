using System;
using System.Buffers.Binary;
using Rabit.Uav.Communications;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>A message of a user: a number, and so many bytes that follow from it.</summary>
internal struct Note
{
    public int Number;
    public int Length;
}

/// <summary>What it looks like on the wire.</summary>
internal sealed class NoteCodec(int messageType = 1000, int version = 1) : IVehicleMessageCodec<Note>
{
    public int MessageType => messageType;

    public int Version => version;

    public bool TryEncode(in Note content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = content.Length;
        if (length < sizeof(int) || length > destination.Length)
            return false;
        BinaryPrimitives.WriteInt32LittleEndian(destination, content.Number);
        for (int i = sizeof(int); i < length; i++)
            destination[i] = unchecked((byte)(content.Number + i));
        return true;
    }

    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out Note content)
    {
        content = default;
        if (bytes.Length < sizeof(int))
            return false;
        content = new Note { Number = BinaryPrimitives.ReadInt32LittleEndian(bytes), Length = bytes.Length };
        for (int i = sizeof(int); i < bytes.Length; i++)
        {
            if (bytes[i] != unchecked((byte)(content.Number + i)))
                return false;
        }

        return true;
    }
}
