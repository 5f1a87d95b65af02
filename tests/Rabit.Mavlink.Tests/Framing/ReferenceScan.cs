using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>
/// The rule written down as plainly as can be, over a whole buffer and without regard to speed: at each byte, is there
/// a frame of a known id with the right checksum? Then skip it whole, else try the next byte.
/// </summary>
internal static class ReferenceScan
{
    public static List<int> OffsetsOfCheckedFrames(byte[] bytes, MavlinkDialect dialect)
    {
        var offsets = new List<int>();
        int position = 0;
        while (position < bytes.Length)
        {
            int length = LengthOfFrameAt(bytes, position, dialect);
            if (length > 0)
                offsets.Add(position);
            position += Math.Max(length, 1);
        }
        return offsets;
    }

    private static int LengthOfFrameAt(byte[] bytes, int start, MavlinkDialect dialect)
    {
        bool isV1 = bytes[start] == 0xFE;
        if (!isV1 && bytes[start] != 0xFD)
            return 0;
        int header = isV1 ? 6 : 10;
        if (start + header > bytes.Length)
            return 0;
        int id = isV1 ? bytes[start + 5] : bytes[start + 7] | (bytes[start + 8] << 8) | (bytes[start + 9] << 16);
        int payload = bytes[start + 1];
        int signature = !isV1 && (bytes[start + 2] & 1) == 1 ? 13 : 0;
        int end = start + header + payload;
        if (end + 2 + signature > bytes.Length || !dialect.TryGetMessage(id, out MavlinkMessageInfo message))
            return 0;
        if (isV1 && (payload < message.MinLength || payload > message.MaxLength))
            return 0;
        ushort crc = MavlinkCrc.Add(MavlinkCrc.Initial, bytes.AsSpan(start + 1, end - start - 1));
        crc = MavlinkCrc.Add(crc, message.CrcExtra);
        return crc == (bytes[end] | (bytes[end + 1] << 8)) ? header + payload + 2 + signature : 0;
    }
}
