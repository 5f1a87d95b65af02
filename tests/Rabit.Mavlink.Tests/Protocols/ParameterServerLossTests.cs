using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Client and server: lists, sets and reads over links that lose, double and reorder.</summary>
public class ParameterServerLossTests(ITestOutputHelper output)
{
    private const int Count = 200;

    [Theory]
    [InlineData(0, MavlinkParameterEncoding.Bytewise)]
    [InlineData(5, MavlinkParameterEncoding.CCast)]
    [InlineData(20, MavlinkParameterEncoding.Bytewise)]
    [InlineData(40, MavlinkParameterEncoding.CCast)]
    public void ListSetRead_ManySeeds_BothSidesAgree(int lossPercent, MavlinkParameterEncoding encoding)
    {
        var statuses = new Dictionary<MavlinkParameterStatus, int>();
        for (ulong seed = 1; seed <= 10; seed++)
        {
            var vehicle = new ParameterServerVehicle(Count, encoding, sendsHash: true);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            var client = new MavlinkParameterClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address, encoding);
            Assert.True(client.TryStartList(world.Now));
            MavlinkParameterOutcome list = End(client, world);
            Assert.True(list.Status == MavlinkParameterStatus.Done, $"{world.Context}: {list}");
            AssertSame(vehicle, client, encoding, world.Context);
            Assert.True(lossPercent > 0 || client.Hash == MavlinkParameterHash.Compute(client.Parameters));

            var random = new ProtocolRandom(seed);
            for (int i = 0; i < 10; i++)
            {
                MavlinkParameterOutcome set = SetOne(vehicle, world, client, random.Below(Count), random.Below(5));
                statuses[set.Status] = statuses.TryGetValue(set.Status, out int times) ? times + 1 : 1;
            }

            Assert.True(client.TryStartRead("NO_SUCH_PARAM", world.Now));
            MavlinkParameterOutcome unknown = End(client, world);
            Assert.True(
                unknown.Error == MavParamError.DoesNotExist
                    || (lossPercent > 0 && unknown.Status == MavlinkParameterStatus.Unknown),
                $"{world.Context}: {unknown}");
            Assert.Equal(0, vehicle.Server.Dropped);
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to 10: "
            + string.Join(", ", statuses.OrderBy(pair => pair.Key).Select(pair => $"{pair.Key} {pair.Value}")));
    }

    [Fact]
    public void List_KnownHash_IsStopped()
    {
        var vehicle = new ParameterServerVehicle(Count, MavlinkParameterEncoding.Bytewise, sendsHash: true);
        var world = new ProtocolWorld(vehicle, 0, 1);
        var client = new MavlinkParameterClient(
            ScriptedVehicle.Companion(), ScriptedVehicle.Address, MavlinkParameterEncoding.Bytewise);
        Assert.True(client.TryStartList(world.Now));
        Assert.Equal(MavlinkParameterStatus.Done, End(client, world).Status);
        Assert.True(client.TryStartList(world.Now, client.Hash));
        Assert.Equal(MavlinkParameterStatus.Unchanged, End(client, world).Status);
        world.RunUntil(() => false, client.Handle, client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(1));
        Assert.False(vehicle.Server.IsListing);

        vehicle.List.Set(0, 77);
        Assert.True(client.TryStartList(world.Now, client.Hash));
        Assert.Equal(MavlinkParameterStatus.Done, End(client, world).Status);
        AssertSame(vehicle, client, MavlinkParameterEncoding.Bytewise, "");
    }

    [Fact]
    public void List_ThatGrowsMeanwhile_IsSentAgain()
    {
        var vehicle = new ParameterServerVehicle(Count, MavlinkParameterEncoding.Bytewise, sendsHash: false);
        var world = new ProtocolWorld(vehicle, 0, 1);
        var client = new MavlinkParameterClient(
            ScriptedVehicle.Companion(), ScriptedVehicle.Address, MavlinkParameterEncoding.Bytewise);
        Assert.True(client.TryStartList(world.Now));
        world.RunUntil(() => false, client.Handle, client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(1));
        vehicle.List.Add("A_NEW_ONE", MavParamType.Real32, 42);
        Assert.Equal(MavlinkParameterStatus.Done, End(client, world).Status);
        Assert.Equal(Count + 1, client.Parameters.Count);
        AssertSame(vehicle, client, MavlinkParameterEncoding.Bytewise, "");
    }

    private static MavlinkParameterOutcome SetOne(
        ParameterServerVehicle vehicle, ProtocolWorld world, MavlinkParameterClient client, int index, int kind)
    {
        MavlinkParameterValue parameter = vehicle.List[index];

        // Only a float can be outside its limits and fit its type.
        bool isRefused = kind == 0 && parameter.Type == MavParamType.Real32;
        double value = isRefused ? 2000 : 100 + kind;
        Assert.True(client.TryStartSet(parameter.Name.ToString(), parameter.Type, value, world.Now));
        MavlinkParameterOutcome set = End(client, world);
        string context = $"{world.Context}, {parameter}, to {value}: {set}";
        if (set.Status == MavlinkParameterStatus.Done)
            Assert.True(!isRefused && vehicle.List[index].Value.Equals(value), context);
        else
            Assert.True(
                set.Status == (isRefused ? MavlinkParameterStatus.Refused : MavlinkParameterStatus.Unknown)
                    || set.Status == MavlinkParameterStatus.Unknown,
                context);
        Assert.True(!isRefused || vehicle.List[index].Value.Equals(parameter.Value), context);
        return set;
    }

    private static MavlinkParameterOutcome End(MavlinkParameterClient client, ProtocolWorld world)
    {
        MavlinkParameterOutcome outcome = default;
        bool ended = world.RunUntil(
            () => client.TryTakeOutcome(out outcome), client.Handle, client.TryTakeFrame, () => client.NextDue,
            TimeSpan.FromSeconds(600));
        Assert.True(ended, world.Context);
        return outcome;
    }

    private static void AssertSame(
        ParameterServerVehicle vehicle, MavlinkParameterClient client, MavlinkParameterEncoding encoding,
        string context)
    {
        for (int i = 0; i < vehicle.List.Count; i++)
        {
            MavlinkParameterValue served = vehicle.List[i];
            MavlinkParameter known = client.Parameters[i];
            Assert.True(
                served.Name == known.Name && served.Type == known.Type && served.Value.Equals(known.ToDouble(encoding)),
                $"{context}: {served}, {known}");
        }
    }
}
