using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>What was asked for, what was said, and what came.</summary>
public class MavlinkRateClientTests
{
    private readonly Dictionary<int, double> _intervals = [];
    private readonly MavlinkSender _vehicle = new(1, 1);

    [Theory]
    [InlineData(0)]
    [InlineData(40)]
    public void Rates_AreAskedForAndMeasured(int lossPercent)
    {
        for (ulong seed = 1; seed <= 20; seed++)
        {
            _intervals.Clear();
            var client = new MavlinkRateClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address, [(Attitude.MavlinkId, 20), (GlobalPositionInt.MavlinkId, 5), (SysStatus.MavlinkId, 1)]);
            Run(client, 0, 60, lossPercent, new ProtocolRandom(seed), largestHertz: 10);
            for (int i = 0; i < client.Count; i++)
            {
                MavlinkStreamRate rate = client[i];
                Assert.InRange(rate.Requests, 1, 12);
                if (rate.Answer == MavlinkRateAnswer.Unanswered && lossPercent > 0)
                    continue;
                Assert.True(rate.Answer == MavlinkRateAnswer.Accepted, $"seed {seed}: {rate}");

                // The vehicle says yes to 20 Hz and sends 10: only measuring shows it.
                double sent = Math.Min(rate.WantedHertz, 10) * (1 - (lossPercent / 100.0));
                Assert.True(Math.Abs(rate.MeasuredHertz - sent) <= (0.45 * sent) + 0.3, $"seed {seed}: {rate}");
                Assert.Equal(i == 0 || lossPercent > 0, rate.IsOffBy(0.2) || lossPercent > 0);
            }
        }
    }

    [Fact]
    public void Rate_ChangedByAnother_IsAskedForAgain()
    {
        var client = new MavlinkRateClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address, [(Attitude.MavlinkId, 10)]);
        Run(client, 0, 20, 0, new ProtocolRandom(1), 50);
        Assert.Equal(1, client[0].Requests);
        _intervals[Attitude.MavlinkId] = 1;   // a ground station
        Run(client, 20, 60, 0, new ProtocolRandom(1), 50);
        Assert.Equal(2, client[0].Requests);
        Assert.InRange(client[0].MeasuredHertz, 9.5, 10.5);
    }

    private void Run(MavlinkRateClient client, int from, int to, int lossPercent, ProtocolRandom random, double largestHertz)
    {
        var next = new Dictionary<int, double>();
        for (int millisecond = from * 1000; millisecond < to * 1000; millisecond += 10)
        {
            TimeSpan now = TimeSpan.FromMilliseconds(millisecond);
            while (client.TryTakeFrame(now, out MavlinkFrame frame))
            {
                if (random.NextDouble() * 100 < lossPercent || !frame.TryDecode(out CommandLong command))
                    continue;
                _intervals[(int)command.Param1] = Math.Max(command.Param2 / 1e6, 1 / largestHertz);
                if (random.NextDouble() * 100 >= lossPercent)
                    client.Handle(_vehicle.Create(new CommandAck { Command = MavCmd.SetMessageInterval, TargetSystem = 1, TargetComponent = 191 }), now);
            }

            foreach (KeyValuePair<int, double> interval in _intervals)
            {
                if (next.TryGetValue(interval.Key, out double at) && now.TotalSeconds < at - 1e-9)
                    continue;
                next[interval.Key] = now.TotalSeconds + interval.Value;
                if (random.NextDouble() * 100 < lossPercent)
                    continue;
                MavlinkFrame message = interval.Key == Attitude.MavlinkId ? _vehicle.Create(default(Attitude))
                    : interval.Key == SysStatus.MavlinkId ? _vehicle.Create(default(SysStatus))
                    : _vehicle.Create(default(GlobalPositionInt));
                client.Handle(message, now);
            }
        }
    }
}
