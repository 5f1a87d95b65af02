using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A component that sends heartbeats. A plain value.</summary>
/// <param name="Address">Who it is.</param>
/// <param name="Heartbeat">Its last heartbeat.</param>
/// <param name="FirstAt">When its first heartbeat came.</param>
/// <param name="LastAt">When its last heartbeat came.</param>
/// <param name="Heartbeats">How many came.</param>
/// <param name="IsLost">Whether they stay away.</param>
/// <param name="Reboots">How often it was seen to begin anew.</param>
public readonly record struct MavlinkComponent(
    MavlinkAddress Address, Heartbeat Heartbeat, TimeSpan FirstAt, TimeSpan LastAt, long Heartbeats, bool IsLost, int Reboots);
