using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>A message that is to be sent to other vehicles, as bytes.</summary>
internal sealed class ExchangeMessage
{
    /// <summary>Its type, and which version of its form.</summary>
    public ushort Type { get; init; }

    public byte Version { get; init; }

    public byte[] Content { get; init; } = [];

    public VehicleDestination Destination { get; init; }

    public VehicleMessageClass Class { get; init; } = VehicleMessageClass.Coordination;

    /// <summary>How long it is worth anything, from now.</summary>
    public TimeSpan Lifetime { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>Over how many other vehicles it may go.</summary>
    public int HopLimit { get; init; }

    public bool IsAcknowledged { get; init; }

    /// <summary>Whatever the sender knows it by; comes back in the report.</summary>
    public long Reference { get; init; }
}
