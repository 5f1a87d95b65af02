using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>How a parameter that is no float travels in the float field of PARAM_VALUE and PARAM_SET.</summary>
public enum MavlinkParameterEncoding
{
    /// <summary>
    /// The field has the bits of the integer: PX4, and <see cref="MavProtocolCapability.ParamEncodeBytewise"/>.
    /// </summary>
    Bytewise,

    /// <summary>
    /// The field has the float of the same value, good for 24 bits: ArduPilot, and
    /// <see cref="MavProtocolCapability.ParamEncodeCCast"/>.
    /// </summary>
    CCast,
}
