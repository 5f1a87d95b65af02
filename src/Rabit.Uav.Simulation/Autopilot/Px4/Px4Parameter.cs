using System;
using System.Runtime.InteropServices;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// One of PX4's parameters: a 32-bit whole number or a float. On the wire a whole number carries its bits in the float
/// field (PARAM_ENCODE_BYTEWISE).
/// </summary>
internal sealed class Px4Parameter(string name, bool isWhole, double value)
{
    public string Name { get; } = name;

    public double Value { get; private set; } = value;

    public int Whole => (int)Value;

    public MavParamType Type => isWhole ? MavParamType.Int32 : MavParamType.Real32;

    /// <summary>As it is sent.</summary>
    public float WireValue => isWhole ? new Bits { Whole = (int)Value }.Float : (float)Value;

    /// <summary>Sets it; a whole number keeps the whole part.</summary>
    public void Set(double newValue) => Value = isWhole ? Math.Truncate(newValue) : newValue;

    /// <summary>Sets it as it came; false where the type is not its own or the value is no number.</summary>
    public bool TrySetWire(float wireValue, MavParamType type)
    {
        if (type != Type)
            return false;
        if (isWhole)
            Value = new Bits { Float = wireValue }.Whole;
        else if (float.IsNaN(wireValue) || float.IsInfinity(wireValue))
            return false;
        else
            Value = wireValue;
        return true;
    }

    [StructLayout(LayoutKind.Explicit)]
    private struct Bits
    {
        [FieldOffset(0)]
        public int Whole;

        [FieldOffset(0)]
        public float Float;
    }
}
