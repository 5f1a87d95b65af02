using System;
using System.Collections.Generic;
using Rabit.Uav.Communications;
using Xunit;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>
/// Two links of a vehicle: one to the autopilot, and a radio under a budget. A test says which of them have room.
/// </summary>
internal sealed class TwoLinks
{
    public const ulong Telemetry = 1;
    public const ulong Radio = 2;

    /// <summary>The links with room.</summary>
    public ulong Free { get; set; } = Telemetry | Radio;

    /// <summary>How long until those without room may have some.</summary>
    public TimeSpan Wait { get; set; }

    public MessageExchange Open(byte systemId, bool announces = false) => new(
        new VehicleExchangeOptions { Announces = announces }, systemId, new ExchangeRandom(1),
        (_, _) => new LinkRoom(Telemetry | Radio, Free) { Wait = Wait });

    /// <summary>Sends all that goes out now.</summary>
    /// <returns>Over which links each datagram goes.</returns>
    public static List<ulong> Send(MessageExchange exchange, double seconds)
    {
        var links = new List<ulong>();
        Span<byte> to = stackalloc byte[ExchangeWire.MaxLength];
        while (exchange.TryNext(TimeSpan.FromSeconds(seconds), to, out ExchangeDatagram datagram))
            links.Add(datagram.Links);
        return links;
    }

    /// <summary>The next datagram that goes out.</summary>
    public static byte[] Next(MessageExchange exchange, double seconds)
    {
        byte[] to = new byte[ExchangeWire.MaxLength];
        Assert.True(exchange.TryNext(TimeSpan.FromSeconds(seconds), to, out ExchangeDatagram datagram));
        return to.AsSpan(0, datagram.Length).ToArray();
    }
}
