using System;
using System.Buffers.Binary;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// The payload of FILE_TRANSFER_PROTOCOL (MAVLink guide, "File Transfer Protocol"): a header of 12 bytes and up to 239
/// bytes of data, in a buffer that is reused.
/// </summary>
internal sealed class FtpPacket
{
    public const int Length = 251;
    public const int HeaderLength = 12;
    public const int MaxData = Length - HeaderLength;

    private const int SessionAt = 2;
    private const int OpcodeAt = 3;
    private const int SizeAt = 4;
    private const int RequestOpcodeAt = 5;
    private const int BurstCompleteAt = 6;
    private const int OffsetAt = 8;

    private readonly byte[] _bytes = new byte[Length];

    public Span<byte> Bytes => _bytes;

    public Span<byte> Data => _bytes.AsSpan(HeaderLength);

    public ushort Sequence
    {
        get => BinaryPrimitives.ReadUInt16LittleEndian(_bytes);
        set => BinaryPrimitives.WriteUInt16LittleEndian(_bytes, value);
    }

    public byte Session
    {
        get => _bytes[SessionAt];
        set => _bytes[SessionAt] = value;
    }

    public FtpOpcode Opcode
    {
        get => (FtpOpcode)_bytes[OpcodeAt];
        set => _bytes[OpcodeAt] = (byte)value;
    }

    /// <summary>Of the data; of a request to read, how much is wanted.</summary>
    public byte Size
    {
        get => _bytes[SizeAt];
        set => _bytes[SizeAt] = value;
    }

    public FtpOpcode RequestOpcode
    {
        get => (FtpOpcode)_bytes[RequestOpcodeAt];
        set => _bytes[RequestOpcodeAt] = (byte)value;
    }

    public bool IsBurstComplete
    {
        get => _bytes[BurstCompleteAt] != 0;
        set => _bytes[BurstCompleteAt] = value ? (byte)1 : (byte)0;
    }

    public uint Offset
    {
        get => BinaryPrimitives.ReadUInt32LittleEndian(_bytes.AsSpan(OffsetAt));
        set => BinaryPrimitives.WriteUInt32LittleEndian(_bytes.AsSpan(OffsetAt), value);
    }

    public void Clear() => Array.Clear(_bytes, 0, _bytes.Length);
}
