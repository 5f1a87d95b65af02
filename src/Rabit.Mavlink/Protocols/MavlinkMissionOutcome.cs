using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>How a mission transfer ended. A plain value.</summary>
/// <param name="Status">How it ended.</param>
/// <param name="Result">The last result that the vehicle gave for it; null where it gave none.</param>
/// <param name="Items">How many items were downloaded, or requested by the vehicle.</param>
/// <param name="OpaqueId">The vehicle's id of what it has now, which changes with it; 0 where it sends none.</param>
/// <param name="Sent">How many frames were sent for it.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkMissionOutcome(
    MavlinkMissionStatus Status, MavMissionResult? Result, int Items, uint OpaqueId, int Sent, TimeSpan EndedAt);
