using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>The header of a part of a message. A plain value.</summary>
internal struct ExchangeFragment
{
    public byte Source;
    public VehicleDestination Destination;

    /// <summary>Session of the source in the upper half, number of the message in the lower.</summary>
    public uint Id;

    public ushort Type;
    public byte TypeVersion;
    public VehicleMessageClass Class;
    public bool IsAcknowledged;
    public byte Hops;
    public byte Index;
    public byte Count;

    /// <summary>Of the sender's GPS time, ms; 0 for none.</summary>
    public byte Accuracy;

    /// <summary>What is left of its life: clocks of vehicles differ.</summary>
    public int LifetimeMs;

    /// <summary>
    /// How long ago it was posted when this was sent, waits at relays included: when it was posted is known without a
    /// common clock, but for the time on the way.
    /// </summary>
    public int AgeMs;

    public long SentUtcMicroseconds;
}
