using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>How an operation on parameters ended. A plain value.</summary>
/// <param name="Status">How it ended.</param>
/// <param name="Parameter">What the vehicle reports, of a read, and of a set where it did; default otherwise.</param>
/// <param name="Error">Why the vehicle refused, where it sent PARAM_ERROR.</param>
/// <param name="Missing">Of a list: how many parameters are missing; -1 where not even their number is known.</param>
/// <param name="Sent">How many frames were sent for it.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkParameterOutcome(
    MavlinkParameterStatus Status, MavlinkParameter Parameter, MavParamError Error, int Missing, int Sent,
    TimeSpan EndedAt);
