using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>The end of a mission transfer. A plain value.</summary>
/// <param name="Verdict">What became of it.</param>
/// <param name="Result">The last result that the vehicle gave for it; null where it gave none.</param>
/// <param name="Items">How many items were downloaded, or asked for by the vehicle.</param>
/// <param name="OpaqueId">The vehicle's id of what it has now, which changes with it; 0 where it sends none.</param>
/// <param name="Sent">How many frames were sent for it.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkMissionOutcome(
    MavlinkMissionVerdict Verdict, MavMissionResult? Result, int Items, uint OpaqueId, int Sent, TimeSpan EndedAt);
