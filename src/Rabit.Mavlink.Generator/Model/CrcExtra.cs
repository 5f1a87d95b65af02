using System.Collections.Generic;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>
/// The checksum byte of a message: CRC-16/MCRF4XX over its name and, in wire order, the type, name and array length of
/// each field that is no extension; both bytes folded into one (MAVLink guide, "CRC_EXTRA calculation").
/// </summary>
internal static class CrcExtra
{
    public static byte Compute(string messageName, IEnumerable<FieldDefinition> wireOrder)
    {
        ushort crc = Add(0xFFFF, messageName + " ");
        foreach (FieldDefinition field in wireOrder)
        {
            crc = Add(crc, field.Type.Name + " ");
            crc = Add(crc, field.Name + " ");
            if (field.ArrayLength != 0)
                crc = Add(crc, (byte)field.ArrayLength);
        }

        return (byte)((crc & 0xFF) ^ (crc >> 8));
    }

    private static ushort Add(ushort crc, string text)
    {
        foreach (char character in text)
            crc = Add(crc, (byte)character);
        return crc;
    }

    private static ushort Add(ushort crc, byte value)
    {
        int mixed = value ^ (crc & 0xFF);
        mixed = (mixed ^ (mixed << 4)) & 0xFF;
        return (ushort)((crc >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4));
    }
}
