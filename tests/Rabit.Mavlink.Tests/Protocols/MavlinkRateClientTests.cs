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
            var client = new MavlinkRateClient(
                ScriptedVehicle.Companion(), ScriptedVehicle.Address,
                [(Attitude.MavlinkId, 20), (GlobalPositionInt.MavlinkId, 5), (SysStatus.MavlinkId, 1)]);
            Run(client, 0, 60, lossPercent, new ProtocolRandom(seed), maxHertz: 10);
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
        var client = new MavlinkRateClient(
            ScriptedVehicle.Companion(), ScriptedVehicle.Address, [(Attitude.MavlinkId, 10)]);
        Run(client, 0, 20, 0, new ProtocolRandom(1), 50);
        Assert.Equal(1, client[0].Requests);
        _intervals[Attitude.MavlinkId] = 1;   // a ground station
        Run(client, 20, 60, 0, new ProtocolRandom(1), 50);
        Assert.Equal(2, client[0].Requests);
        Assert.InRange(client[0].MeasuredHertz, 9.5, 10.5);
    }

    // What happens: s a restart, a/r/t/p an answer (accepted, refused, temporarily rejected, in progress), w a wait of
    // 0.7 s, . of half of that. What is sent: message id and confirmation; g and the id for one that was given up, f
    // and the id for one that was refused.
    [Theory]
    [InlineData("", "30/0", 0, 0, 0)]
    [InlineData("aaa", "30/0 33/0 1/0", 3, 0, 0)]
    [InlineData("aaaaww", "30/0 33/0 1/0", 3, 0, 0)]
    [InlineData(".", "30/0", 0, 0, 0)]
    [InlineData("..", "30/0 30/1", 0, 0, 0)]
    [InlineData("wwa", "30/0 30/1 30/2 33/0", 1, 0, 0)]
    [InlineData("www", "30/0 30/1 30/2 33/0 g30", 0, 0, 1)]
    [InlineData("wwwwwwwww", "30/0 30/1 30/2 33/0 g30 33/1 33/2 1/0 g33 1/1 1/2 g1", 0, 0, 3)]
    [InlineData("rarww", "30/0 33/0 f30 1/0 f1", 1, 2, 0)]
    [InlineData("t.a", "30/0 33/0", 1, 0, 0)]
    [InlineData("twa", "30/0 30/1 33/0", 1, 0, 0)]
    [InlineData(".p.a", "30/0 33/0", 1, 0, 0)]
    [InlineData("asa", "30/0 33/0 30/0 33/0", 2, 0, 0)]
    [InlineData("raasraa", "30/0 33/0 f30 1/0 30/0 33/0 f30 1/0", 4, 2, 0)]
    public void TryTakeFrame_Script_AsksOneByOne(
        string script, string expected, int accepted, int refused, int unanswered)
    {
        var client = new MavlinkRateClient(
            ScriptedVehicle.Companion(), ScriptedVehicle.Address, [(30, 25), (33, 10), (1, 0.5)]);
        var answers = new int[4];
        var seen = new List<string>();
        TimeSpan now = TimeSpan.Zero;
        foreach (char step in "." + script)
        {
            if (step == 's')
                client.Restart();
            else if (step is 'w' or '.')
                now += new TimeSpan(MavlinkRateClient.AnswerTimeout.Ticks / (step == 'w' ? 1 : 2));
            else
                client.Handle(
                    _vehicle.Create(
                        new CommandAck
                        {
                            Command = MavCmd.SetMessageInterval,
                            Result = ResultOf(step),
                            TargetSystem = 1,
                            TargetComponent = 191
                        }),
                    now);

            // Until there is no more to send: one that was sent is waited for.
            while (client.TryTakeFrame(now, out MavlinkFrame frame))
            {
                Assert.True(frame.TryDecode(out CommandLong command));
                seen.Add(FormattableString.Invariant($"{command.Param1}/{command.Confirmation}"));
            }

            while (client.TryTakeAnswer(out MavlinkStreamRate rate))
            {
                answers[(int)rate.Answer]++;
                if (rate.Answer != MavlinkRateAnswer.Accepted)
                    seen.Add(
                        (rate.Answer == MavlinkRateAnswer.Refused ? "f" : "g")
                            + FormattableString.Invariant($"{rate.MessageId}"));
            }
        }

        Assert.Equal(expected, string.Join(" ", seen));
        Assert.Equal([0, accepted, refused, unanswered], answers);
        Assert.Equal(seen.FindAll(s => s.IndexOf('/') > 0).Count, client.Requests);
    }

    [Fact]
    public void TryTakeFrame_Rate_IsSentAsAnIntervalInMicroseconds()
    {
        var client = new MavlinkRateClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address, [(30, 25)]);
        Assert.True(
            client.TryTakeFrame(TimeSpan.Zero, out MavlinkFrame frame) && frame.TryDecode(out CommandLong command)
                && command.Command == MavCmd.SetMessageInterval);
        frame.TryDecode(out command);
        Assert.Equal((30f, 40_000f, 0f, 0f, 0f, 0f, 0f), (command.Param1, command.Param2, command.Param3,
            command.Param4, command.Param5, command.Param6, command.Param7));
    }

    [Fact]
    public void TryTakeFrame_NoRates_AsksNothing()
    {
        var client = new MavlinkRateClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address, []);
        Assert.False(client.TryTakeFrame(TimeSpan.Zero, out _));
        client.Handle(
            _vehicle.Create(new CommandAck { Command = MavCmd.SetMessageInterval, Result = MavResult.Failed }),
            TimeSpan.Zero);
        Assert.False(client.TryTakeAnswer(out _));
    }

    private static MavResult ResultOf(char step) => step switch
    {
        'a' => MavResult.Accepted,
        'r' => MavResult.Unsupported,
        't' => MavResult.TemporarilyRejected,
        'p' => MavResult.InProgress,
        _ => throw new ArgumentOutOfRangeException(nameof(step), step, "no such step"),
    };

    private void Run(
        MavlinkRateClient client, int from, int to, int lossPercent, ProtocolRandom random, double maxHertz)
    {
        var next = new Dictionary<int, double>();
        for (int millisecond = from * 1000; millisecond < to * 1000; millisecond += 10)
        {
            TimeSpan now = TimeSpan.FromMilliseconds(millisecond);
            while (client.TryTakeFrame(now, out MavlinkFrame frame))
            {
                if (random.NextDouble() * 100 < lossPercent || !frame.TryDecode(out CommandLong command))
                    continue;
                _intervals[(int)command.Param1] = Math.Max(command.Param2 / 1e6, 1 / maxHertz);
                if (random.NextDouble() * 100 >= lossPercent)
                    client.Handle(
                        _vehicle.Create(
                            new CommandAck
                            {
                                Command = MavCmd.SetMessageInterval,
                                TargetSystem = 1,
                                TargetComponent = 191
                            }),
                        now);
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
