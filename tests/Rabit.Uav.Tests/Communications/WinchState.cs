using System;
using System.Buffers.Binary;
using Rabit.Mavlink;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A message of a user's dialect, as the generator makes it: its id is in none of ours.</summary>
internal struct WinchState : IMavlinkMessage
{
    public const int MavlinkId = 54_321;
    public const byte MavlinkCrcExtra = 77;
    private const int Length = 4;

    public ushort LineCentimetres { get; set; }

    public byte TargetSystem { get; set; }

    public byte TargetComponent { get; set; }

    /// <summary>Ours and the user's together.</summary>
    public static MavlinkDialect Dialect { get; } = MavlinkDialect.Combine(
        "mine",
        MavlinkDialect.All,
        new MavlinkDialect(
            "winch", [new MavlinkMessageInfo(MavlinkId, "WINCH_STATE", MavlinkCrcExtra, Length, Length, 2, 3)]));

    public readonly int MessageId => MavlinkId;

    public readonly byte CrcExtra => MavlinkCrcExtra;

    public readonly int MinLength => Length;

    public readonly int MaxLength => Length;

    public readonly void Encode(Span<byte> payload)
    {
        BinaryPrimitives.WriteUInt16LittleEndian(payload, LineCentimetres);
        payload[2] = TargetSystem;
        payload[3] = TargetComponent;
    }

    public void Decode(ReadOnlySpan<byte> payload)
    {
        LineCentimetres = BinaryPrimitives.ReadUInt16LittleEndian(payload);
        TargetSystem = payload[2];
        TargetComponent = payload[3];
    }
}
