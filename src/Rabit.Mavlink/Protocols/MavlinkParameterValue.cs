using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A parameter as a <see cref="MavlinkParameterServer"/> serves it. A plain value.</summary>
/// <param name="Name">At most 16 characters.</param>
/// <param name="Type">Its type, not one of 64 bits: these do not fit on the wire.</param>
/// <param name="Value">Its value; of an integer type a whole number.</param>
public readonly record struct MavlinkParameterValue(Text16 Name, MavParamType Type, double Value);
