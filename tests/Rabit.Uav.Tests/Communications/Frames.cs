using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Frames as bytes, and back.</summary>
internal static class Frames
{
    /// <summary>An id that no dialect knows.</summary>
    public const int UnknownId = 0x00ABCDEF;

    public static byte[] Bytes(in MavlinkFrame frame)
    {
        var bytes = new byte[frame.WireLength];
        frame.WriteTo(bytes);
        return bytes;
    }

    public static byte[] Of<T>(
        T message, byte system = 1, byte component = 1, byte sequence = 0, MavlinkVersion version = MavlinkVersion.V2)
        where T : struct, IMavlinkMessage => Bytes(MavlinkFrame.Create(message, system, component, sequence, version));

    /// <summary>A heartbeat of a copter's autopilot.</summary>
    public static byte[] Heartbeat(byte system = 1, byte component = 1, byte sequence = 0)
        => Of(
            new Heartbeat { Type = MavType.Quadrotor, Autopilot = MavAutopilot.Ardupilotmega, MavlinkVersion = 3 },
            system, component, sequence);

    public static CommandLong Command(byte system, byte component)
        => new() { TargetSystem = system, TargetComponent = component, Command = MavCmd.RequestMessage, Param1 = 148 };

    /// <summary>
    /// A MAVLink 2 frame of any id, with zeros at the end of its payload where the caller wants them, and a signature
    /// of 13 bytes if asked for.
    /// </summary>
    public static byte[] Raw(int messageId, byte[] payload, byte crcExtra = 0, bool isSigned = false)
    {
        var bytes = new List<byte>
        {
            0xFD, (byte)payload.Length, isSigned ? (byte)1 : (byte)0, 0, 7, 1, 1, (byte)messageId,
            (byte)(messageId >> 8), (byte)(messageId >> 16),
        };
        bytes.AddRange(payload);
        ushort crc = MavlinkCrc.Add(MavlinkCrc.Add(MavlinkCrc.Initial, bytes.Skip(1).ToArray()), crcExtra);
        bytes.Add((byte)crc);
        bytes.Add((byte)(crc >> 8));
        if (isSigned)
            bytes.AddRange(Enumerable.Repeat((byte)0x5A, MavlinkFrame.SignatureLength));
        return bytes.ToArray();
    }

    public static byte[] Join(IEnumerable<byte[]> parts) => parts.SelectMany(p => p).ToArray();

    public static string Hex(byte[] bytes) => BitConverter.ToString(bytes);

    /// <summary>All frames that the bytes are; those with a known id have a right checksum.</summary>
    public static List<MavlinkFrame> Read(byte[] bytes)
    {
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var rest = new ReadOnlySpan<byte>(bytes);
        var frames = new List<MavlinkFrame>();
        while (reader.TryRead(ref rest, out MavlinkFrame frame, out _))
            frames.Add(frame);
        while (reader.TryFlush(out MavlinkFrame frame, out _))
            frames.Add(frame);
        return frames;
    }
}
