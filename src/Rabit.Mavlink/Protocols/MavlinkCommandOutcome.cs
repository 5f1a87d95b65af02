using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>The end of a command. A plain value.</summary>
/// <param name="Handle">What <see cref="MavlinkCommandClient.TryStart"/> gave.</param>
/// <param name="Command">The command.</param>
/// <param name="Verdict">What became of it.</param>
/// <param name="Result">The final result of the vehicle; null where it gave none.</param>
/// <param name="ResultParam2">What the vehicle added to its result; 0 is nothing.</param>
/// <param name="Sent">How often the command went out; 0 where it was cancelled before.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkCommandOutcome(
    int Handle, MavlinkCommand Command, MavlinkCommandVerdict Verdict, MavResult? Result, int ResultParam2, int Sent, TimeSpan EndedAt);
