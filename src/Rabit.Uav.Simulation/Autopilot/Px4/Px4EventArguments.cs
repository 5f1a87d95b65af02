using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>Packs the arguments of an EVENT one after the other, least significant byte first.</summary>
internal struct Px4EventArguments
{
    private ByteArray40 _bytes;
    private int _length;

    public readonly ByteArray40 Bytes => _bytes;

    public Px4EventArguments Byte(int value)
    {
        Put((byte)value);
        return this;
    }

    public Px4EventArguments UInt16(int value) => Byte(value).Byte(value >> 8);

    public Px4EventArguments UInt32(uint value) => UInt16((ushort)value).UInt16((int)(value >> 16));

    public Px4EventArguments Float(double value)
    {
        byte[] bytes = BitConverter.GetBytes((float)value);
        return Byte(bytes[0]).Byte(bytes[1]).Byte(bytes[2]).Byte(bytes[3]);
    }

    private void Put(byte value) => _bytes[_length++] = value;
}
