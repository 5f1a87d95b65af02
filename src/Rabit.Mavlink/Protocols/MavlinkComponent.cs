using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A component that sends heartbeats. A plain value.</summary>
/// <param name="Address">Its address.</param>
/// <param name="Heartbeat">Its last heartbeat.</param>
/// <param name="FirstAt">When its first heartbeat was received.</param>
/// <param name="LastAt">When its last heartbeat was received.</param>
/// <param name="Heartbeats">How many were received.</param>
/// <param name="IsLost">Whether it counts as lost.</param>
/// <param name="Reboots">How many reboots were detected.</param>
public readonly record struct MavlinkComponent(
    MavlinkAddress Address, Heartbeat Heartbeat, TimeSpan FirstAt, TimeSpan LastAt, long Heartbeats, bool IsLost,
    int Reboots);
