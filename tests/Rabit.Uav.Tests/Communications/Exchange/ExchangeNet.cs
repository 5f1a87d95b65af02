using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>
/// Vehicles that exchange messages in virtual time, over ways that lose, repeat and delay each datagram by its own: by
/// the seed.
/// </summary>
internal sealed class ExchangeNet
{
    private readonly Random _random;
    private readonly SortedDictionary<(TimeSpan Due, long Order), (int To, byte From, byte[] Bytes)> _onTheWay = [];
    private readonly byte[] _buffer = new byte[ExchangeWire.MaxLength];
    private readonly TimeSpan[] _mediumFreeAt;
    private long _order;

    public ExchangeNet(int vehicles, int seed, Func<int, VehicleExchangeOptions>? options = null)
    {
        _random = new Random(seed);
        _mediumFreeAt = new TimeSpan[vehicles];
        for (int i = 0; i < vehicles; i++)
        {
            Nodes.Add(Make(i, seed, options));
            Received.Add([]);
            Reports.Add([]);
        }
    }

    public List<MessageExchange> Nodes { get; } = [];

    public List<List<ReceivedExchangeMessage>> Received { get; } = [];

    public List<List<DeliveryReport>> Reports { get; } = [];

    public TimeSpan Now { get; private set; }

    public double Loss { get; set; }

    public double Repetition { get; set; }

    public double DelayMs { get; set; } = 20;

    public double JitterMs { get; set; }

    /// <summary>Of each sender; 0 for no limit.</summary>
    public double BytesPerSecond { get; set; }

    /// <summary>Who reaches whom.</summary>
    public Func<int, int, bool> Reaches { get; set; } = (_, _) => true;

    public long Datagrams { get; private set; }

    public long Bytes { get; private set; }

    public void Post(int from, ExchangeMessage message) => Nodes[from].Post(message, Now);

    public void Put(int to, byte sender, byte[] datagram) => Nodes[to].Take(datagram, sender, Now);

    /// <summary>Replaces a vehicle by one that was started again.</summary>
    public void Restart(int vehicle, int seed) => Nodes[vehicle] = Make(vehicle, seed, null);

    public void Run(double seconds)
    {
        TimeSpan end = Now + TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond));
        while (true)
        {
            Pump();
            TimeSpan next = _onTheWay.Count > 0 ? _onTheWay.First().Key.Due : TimeSpan.MaxValue;
            for (int i = 0; i < Nodes.Count; i++)
            {
                TimeSpan due = Nodes[i].NextDue(Now);
                due = due > _mediumFreeAt[i] ? due : _mediumFreeAt[i];
                next = due < next ? due : next;
            }

            if (next > end)
                break;
            Now = next > Now ? next : Now + TimeSpan.FromTicks(1);
            Deliver();
        }

        Now = end;
    }

    private MessageExchange Make(int vehicle, int seed, Func<int, VehicleExchangeOptions>? options)
    {
        var exchange = new MessageExchange(
            options?.Invoke(vehicle) ?? new VehicleExchangeOptions(), (byte)(vehicle + 1),
            new ExchangeRandom((seed * 1000) + vehicle));
        exchange.Understand(7, newestVersion: 2);
        return exchange;
    }

    private void Pump()
    {
        for (int from = 0; from < Nodes.Count; from++)
        {
            while (_mediumFreeAt[from] <= Now && Nodes[from].TryNext(Now, _buffer, out ExchangeDatagram datagram))
                Transmit(from, datagram);
            while (Nodes[from].TryReceive(out ReceivedExchangeMessage? message))
                Received[from].Add(message!);
            while (Nodes[from].TryReport(out ExchangeMessage? message, out DeliveryReport report))
            {
                if (message!.IsAcknowledged)
                    Reports[from].Add(report);
            }
        }
    }

    private void Transmit(int from, in ExchangeDatagram datagram)
    {
        Datagrams++;
        Bytes += datagram.Length + 17;
        if (BytesPerSecond > 0)
            _mediumFreeAt[from] = Now + Ms((datagram.Length + 17) / BytesPerSecond * 1000);
        byte[] bytes = _buffer.Take(datagram.Length).ToArray();
        for (int to = 0; to < Nodes.Count; to++)
        {
            bool isAddressed = datagram.TargetSystem == 0 || datagram.TargetSystem == to + 1;
            if (to == from || !isAddressed || !Reaches(from, to))
                continue;
            int copies = _random.NextDouble() < Repetition ? 2 : 1;
            for (int copy = 0; copy < copies; copy++)
            {
                if (_random.NextDouble() >= Loss)
                    _onTheWay.Add(
                        (Now + Ms(DelayMs + (_random.NextDouble() * JitterMs)), _order++),
                        (to, (byte)(from + 1), bytes));
            }
        }
    }

    private void Deliver()
    {
        while (_onTheWay.Count > 0)
        {
            KeyValuePair<(TimeSpan Due, long Order), (int To, byte From, byte[] Bytes)> first = _onTheWay.First();
            if (first.Key.Due > Now)
                return;
            _onTheWay.Remove(first.Key);
            Nodes[first.Value.To].Take(first.Value.Bytes, first.Value.From, Now);
        }
    }

    private static TimeSpan Ms(double milliseconds)
        => TimeSpan.FromTicks((long)(milliseconds * TimeSpan.TicksPerMillisecond));
}
