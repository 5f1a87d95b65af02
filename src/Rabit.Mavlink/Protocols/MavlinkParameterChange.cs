using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A request to set a parameter (PARAM_SET). A plain value.</summary>
/// <param name="Index">Of the parameter, in its <see cref="IMavlinkParameterStore"/>.</param>
/// <param name="Parameter">The parameter as it stands.</param>
/// <param name="Value">The value wanted.</param>
/// <param name="Source">Who wants it.</param>
/// <param name="IsSigned">Whether the frame was signed; the reader's verifier has checked the signature.</param>
public readonly record struct MavlinkParameterChange(
    int Index, MavlinkParameterValue Parameter, double Value, MavlinkAddress Source, bool IsSigned);
