using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>How a command ended. A plain value.</summary>
/// <param name="Handle">What <see cref="MavlinkCommandClient.TryStart"/> gave.</param>
/// <param name="Command">The command.</param>
/// <param name="Status">How it ended.</param>
/// <param name="Result">The final result of the vehicle; null where it gave none.</param>
/// <param name="ResultParam2"><c>result_param2</c> of the final answer; 0 where there is none.</param>
/// <param name="Sent">How often the command was sent; 0 where it was cancelled before.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkCommandOutcome(
    int Handle, MavlinkCommand Command, MavlinkCommandStatus Status, MavResult? Result, int ResultParam2, int Sent,
    TimeSpan EndedAt);
