using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>A thousand parameters, and reads and sets, over links that lose, double and reorder.</summary>
public class ParameterLossTests(ITestOutputHelper output)
{
    private const int Count = 1000;

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void List_FewSeeds_CompletesOrFailsCleanly(int lossPercent) => RunList(lossPercent, 3);

    [Theory, Trait("Category", "Long")]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void List_AllSeeds_CompletesOrFailsCleanly(int lossPercent) => RunList(lossPercent, 200);

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void ReadAndSet_ManySeeds_OneOutcomeEach(int lossPercent)
    {
        var statuses = new Dictionary<MavlinkParameterStatus, int>();
        for (ulong seed = 1; seed <= 200; seed++)
        {
            var vehicle = new ParameterVehicle(20);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            MavlinkParameterClient client = Client();
            string context = world.Context;
            for (int i = 0; i < 4; i++)
            {
                string name = vehicle.Parameters[i].Name;

                // Back and forth on one name: reports of the value before must not pass for the one that was set.
                float value = i < 2 ? 7 : 8 + i;
                Assert.True(
                    client.TryStartSet(
                        i < 2 ? name : vehicle.Parameters[0].Name, MavParamType.Real32, value, world.Now));
                MavlinkParameterOutcome set = End(client, world, context);
                Assert.True(set.Sent <= 6, context);
                Count1(statuses, set.Status);
                if (set.Status == MavlinkParameterStatus.Done)
                    Assert.Equal(value, vehicle.Parameters[i < 2 ? i : 0].Value);
                Assert.True(client.TryStartRead(name, world.Now));
                MavlinkParameterOutcome read = End(client, world, context);
                Count1(statuses, read.Status);
                if (read.Status == MavlinkParameterStatus.Done)
                    Assert.True(
                        read.Parameter.Name.TextEquals(name)
                            && read.Parameter.ToDouble(client.Encoding).Equals(vehicle.Parameters[i].Value),
                        context);
            }

            Assert.True(client.TryStartSet(vehicle.Parameters[5].Name, MavParamType.Real32, 5000, world.Now));
            MavlinkParameterOutcome limited = End(client, world, context);
            Assert.True(
                limited.Status is MavlinkParameterStatus.Refused
                    || (lossPercent > 0 && limited.Status is MavlinkParameterStatus.Unknown),
                $"{context}: {limited}");
            Assert.True(client.TryStartRead("NO_SUCH_PARAM", world.Now));
            Assert.Equal(MavlinkParameterStatus.Unknown, End(client, world, context).Status);
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to 200: "
            + $"{string.Join(", ", statuses.OrderBy(pair => pair.Key).Select(pair => $"{pair.Key} {pair.Value}"))}");
        if (lossPercent == 0)
            Assert.Single(statuses);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(20)]
    public void List_ThatGrowsMeanwhile_IsReadAgain(int lossPercent)
    {
        for (ulong seed = 1; seed <= 10; seed++)
        {
            var vehicle = new ParameterVehicle(100) { GrowsAfter = 60 };
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            MavlinkParameterClient client = Client();
            Assert.True(client.TryStartList(world.Now));
            MavlinkParameterOutcome outcome = End(client, world, $"seed {seed}");
            Assert.Equal(MavlinkParameterStatus.Done, outcome.Status);
            AssertSame(vehicle, client, $"seed {seed}");
        }
    }

    [Fact]
    public void List_KnownHash_IsStopped()
    {
        var vehicle = new ParameterVehicle(Count) { Hash = 0x12345678 };
        var world = new ProtocolWorld(vehicle, 0, 1);
        MavlinkParameterClient client = Client();
        Assert.True(client.TryStartList(world.Now));
        Assert.Equal(MavlinkParameterStatus.Done, End(client, world, "").Status);
        Assert.Equal(0x12345678u, client.Hash);

        Assert.True(client.TryStartList(world.Now, client.Hash));
        Assert.Equal(MavlinkParameterStatus.Unchanged, End(client, world, "").Status);
        world.RunUntil(() => false, client.Handle, client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(1));
        Assert.Equal(TimeSpan.MaxValue, vehicle.NextDue);   // it streams no more
        AssertSame(vehicle, client, "");

        Assert.True(client.TryStartList(world.Now, 1));
        Assert.Equal(MavlinkParameterStatus.Done, End(client, world, "").Status);
    }

    private static MavlinkParameterClient Client()
        => new(ScriptedVehicle.Companion(), ScriptedVehicle.Address, MavlinkParameterEncoding.Bytewise);

    private void RunList(int lossPercent, int seeds)
    {
        int done = 0;
        double longest = 0;
        long frames = 0;
        for (ulong seed = 1; seed <= (ulong)seeds; seed++)
        {
            var vehicle = new ParameterVehicle(Count);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            MavlinkParameterClient client = Client();
            TimeSpan start = world.Now;
            string context = world.Context;
            Assert.True(client.TryStartList(world.Now));
            MavlinkParameterOutcome outcome = End(client, world, context);
            longest = Math.Max(longest, (outcome.EndedAt - start).TotalSeconds);
            frames += world.FramesUp;
            if (outcome.Status == MavlinkParameterStatus.Done)
            {
                done++;
                AssertSame(vehicle, client, context);
            }
            else
            {
                Assert.True(
                    outcome.Status == MavlinkParameterStatus.Incomplete && outcome.Missing != 0,
                    $"{context}: {outcome}");
            }
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to {seeds}: {done} complete, longest {longest:F1} s, "
            + $"{frames / seeds} frames sent for one list");
        Assert.True(done >= seeds * (lossPercent <= 20 ? 1.0 : 0.9), $"{done} of {seeds}");
    }

    private static void AssertSame(ParameterVehicle vehicle, MavlinkParameterClient client, string context)
    {
        Assert.True(client.Parameters.Count == vehicle.Parameters.Count && client.Parameters.Missing == 0, context);
        for (int i = 0; i < vehicle.Parameters.Count; i++)
        {
            MavlinkParameter parameter = client.Parameters[i];
            Assert.True(
                parameter.Name.TextEquals(vehicle.Parameters[i].Name)
                    && parameter.ToDouble(client.Encoding).Equals(vehicle.Parameters[i].Value),
                $"{context}, {i}: {parameter}");
        }
    }

    private static void Count1(Dictionary<MavlinkParameterStatus, int> statuses, MavlinkParameterStatus status) =>
        statuses[status] = statuses.TryGetValue(status, out int count) ? count + 1 : 1;

    private static MavlinkParameterOutcome End(MavlinkParameterClient client, ProtocolWorld world, string context)
    {
        MavlinkParameterOutcome outcome = default;
        Assert.True(world.RunUntil(() => client.TryTakeOutcome(out outcome), client.Handle, client.TryTakeFrame, () =>
            client.NextDue, TimeSpan.FromSeconds(300)), context + ": no outcome");
        Assert.False(client.TryTakeOutcome(out _), context);
        return outcome;
    }
}
