using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>Why a parameter was not set. A plain value.</summary>
/// <param name="Error">For PARAM_ERROR.</param>
/// <param name="Reason">
/// For the operator, sent as STATUSTEXT: names the parameter and what it may be. Empty: no text is sent.
/// </param>
public readonly record struct MavlinkParameterRefusal(MavParamError Error, string Reason);
