using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>The end of an operation on parameters. A plain value.</summary>
/// <param name="Verdict">What became of it.</param>
/// <param name="Parameter">What the vehicle has, of a read, and of a set where it said; default otherwise.</param>
/// <param name="Error">Why the vehicle refused, where it said so.</param>
/// <param name="Missing">Of a list: how many parameters are missing; -1 where not even their number is known.</param>
/// <param name="Sent">How many frames were sent for it.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkParameterOutcome(
    MavlinkParameterVerdict Verdict, MavlinkParameter Parameter, MavParamError Error, int Missing, int Sent, TimeSpan EndedAt);
