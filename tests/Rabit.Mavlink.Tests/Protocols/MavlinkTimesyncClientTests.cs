using System;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Two clocks and a link between them.</summary>
public class MavlinkTimesyncClientTests(ITestOutputHelper output)
{
    private const double Drift = 20e-6;
    private const double Offset = 1234.5;

    // Each way 20 ms and up to 5 ms more or less.
    [Theory]
    [InlineData(0)]
    [InlineData(40)]
    public void Filter_JitteryLink_IsRightWithinTwoMilliseconds(int lossPercent)
    {
        double worst = 0;
        for (ulong seed = 1; seed <= 50; seed++)
        {
            var random = new ProtocolRandom(seed);
            var client = new MavlinkTimesyncClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
            for (double now = 100; now < 220; now += 0.1)
            {
                if (client.TryTakeFrame(TimeSpan.FromSeconds(now), out MavlinkFrame frame)
                    && random.NextDouble() >= lossPercent / 100.0)
                {
                    Assert.True(frame.TryDecode(out Timesync request) && request.Tc1 == 0 && request.TargetSystem == 1);
                    double there = now + 0.015 + (0.01 * random.NextDouble());
                    double back = there + 0.015 + (0.01 * random.NextDouble());
                    request.Tc1 = (long)(TheirTime(there) * 1e9);
                    request.TargetComponent = 191;
                    client.Handle(MavlinkFrame.Create(request, 1, 1, 0), TimeSpan.FromSeconds(back));
                }

                if (now > 140)
                {
                    Assert.True(client.Filter.IsKnown(TimeSpan.FromSeconds(now)), $"seed {seed}");
                    worst = Math.Max(worst, Math.Abs(client.Filter.OffsetSecondsAt(now) - (TheirTime(now) - now)));
                }
            }
        }

        output.WriteLine($"{lossPercent} % lost, seeds 1 to 50: {worst * 1e3:F2} ms at worst");
        Assert.InRange(worst, 0, 2e-3);
    }

    // PX4 1.14 leaves the target of its answers uninitialised.
    [Theory]
    [InlineData(200, 14)]
    [InlineData(0, 0)]
    public void Answer_WithAnyTarget_IsMatchedByTheTimeInIt(byte system, byte component)
    {
        var client = new MavlinkTimesyncClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
        for (double now = 1; now < 6; now += 0.1)
        {
            if (!client.TryTakeFrame(TimeSpan.FromSeconds(now), out MavlinkFrame frame))
                continue;
            Assert.True(frame.TryDecode(out Timesync request));
            request.Tc1 = (long)(TheirTime(now + 0.01) * 1e9);
            (request.TargetSystem, request.TargetComponent) = (system, component);
            client.Handle(MavlinkFrame.Create(request, 1, 1, 0), TimeSpan.FromSeconds(now + 0.02));
        }

        Assert.True(client.Filter.IsKnown(TimeSpan.FromSeconds(6)));
    }

    [Fact]
    public void Answer_ToARequestOfAnother_IsNotTaken()
    {
        var client = new MavlinkTimesyncClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
        Assert.True(client.TryTakeFrame(TimeSpan.FromSeconds(1), out _));
        for (int i = 0; i < 10; i++)
        {
            var answer = new Timesync { Ts1 = 77 + i, Tc1 = 1_000_000 + i, TargetSystem = 1, TargetComponent = 191 };
            client.Handle(MavlinkFrame.Create(answer, 1, 1, 0), TimeSpan.FromSeconds(1.1 + (i * 0.1)));
        }

        Assert.False(client.Filter.IsKnown(TimeSpan.FromSeconds(3)));
    }

    [Fact]
    public void Question_OfAnother_IsAnsweredWithOurTime()
    {
        var client = new MavlinkTimesyncClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
        Assert.True(client.TryTakeFrame(TimeSpan.FromSeconds(1), out _));
        client.Handle(MavlinkFrame.Create(new Timesync { Ts1 = 77 }, 1, 1, 0), TimeSpan.FromSeconds(2));
        Assert.True(client.TryTakeFrame(TimeSpan.FromSeconds(2), out MavlinkFrame frame));
        Assert.True(frame.TryDecode(out Timesync answer));
        Assert.Equal(
            (77L, 2_000_000_001L, (byte)1, (byte)1),
            (answer.Ts1, answer.Tc1, answer.TargetSystem, answer.TargetComponent));
    }

    private static double TheirTime(double ours) => Offset + (ours * (1 + Drift));
}
