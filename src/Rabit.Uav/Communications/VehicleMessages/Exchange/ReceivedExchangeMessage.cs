using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>A message of another vehicle, whole.</summary>
internal sealed class ReceivedExchangeMessage
{
    public byte SourceSystemId { get; init; }

    public uint Id { get; init; }

    public ushort Type { get; init; }

    public byte Version { get; init; }

    public byte[] Content { get; init; } = [];

    public VehicleDestination Destination { get; init; }

    public VehicleMessageClass Class { get; init; }

    /// <summary>When it was whole here.</summary>
    public TimeSpan ReceivedTime { get; init; }

    /// <summary>When it was posted, by the clock of the run here: late by the time on the way.</summary>
    public TimeSpan PostedTime { get; init; }

    /// <summary>When it was posted, by GPS, microseconds since 1970 UTC; 0 where its sender had no such time.</summary>
    public long SentUtcMicroseconds { get; init; }

    /// <summary>How good that is; null where the sender had no such time.</summary>
    public TimeSpan? TimeAccuracy { get; init; }

    /// <summary>Whether it came over another vehicle.</summary>
    public bool IsRelayed { get; init; }
}
