using System;

namespace Rabit.Mavlink.Framing;

/// <summary>Cold paths, so that the hot ones stay small enough to be inlined.</summary>
internal static class ThrowHelper
{
    public static void PayloadIndexOutOfRange(int index) =>
        throw new ArgumentOutOfRangeException(
            nameof(index), index, $"A payload has bytes 0 to {WireFormat.MaxPayloadLength - 1}.");

    public static void DestinationTooShort(int needed, int given, string destination) =>
        throw new ArgumentException($"The span has {given} bytes, {needed} are needed.", destination);

    public static void NotAVersion(MavlinkVersion version) =>
        throw new ArgumentOutOfRangeException(nameof(version), version, "A frame is made for MavlinkVersion.V1 or V2.");

    public static void NotInMavlink1(Type message, int messageId) =>
        throw new ArgumentException(
            $"{message.Name} has id {messageId}; MAVLink 1 carries ids up to {WireFormat.MaxMessageIdV1} only. Send it "
                + "as MAVLink 2.",
            nameof(message));
}
