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

    [StructLayout(LayoutKind.Explicit)]
    private struct Bits
    {
        [FieldOffset(0)]
        public int Whole;

        [FieldOffset(0)]
        public float Float;
    }
}
