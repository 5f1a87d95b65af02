namespace Rabit.Mavlink;

/// <summary>One named value of an enum. A plain value.</summary>
public readonly struct MavlinkEnumEntry
{
    internal MavlinkEnumEntry(string name, long value)
    {
        Name = name;
        Value = value;
    }

    /// <summary>Name as the definition writes it, for example <c>MAV_TYPE_QUADROTOR</c>.</summary>
    public string Name { get; }

    /// <summary>
    /// The number. One above <see cref="long.MaxValue"/>, which only a flag of bit 63 is, has the same 64 bits here.
    /// </summary>
    public long Value { get; }
}
