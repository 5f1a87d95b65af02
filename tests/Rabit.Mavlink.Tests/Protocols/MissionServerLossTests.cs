using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Client and server: transfers over links that lose, double and reorder.</summary>
public class MissionServerLossTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(0, false)]
    [InlineData(0, true)]
    [InlineData(5, false)]
    [InlineData(20, false)]
    [InlineData(20, true)]
    [InlineData(40, false)]
    public void UploadDownloadClear_ManySeeds_NeverAMixture(int lossPercent, bool isArduPilot)
    {
        var statuses = new Dictionary<MavlinkMissionStatus, int>();
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var vehicle = new MissionServerVehicle(new MavlinkMissionServerOptions
            {
                BehavesAsArduPilot = isArduPilot,
                RequestInterval = TimeSpan.FromSeconds(isArduPilot ? 1 : 0.25),
                Timeout = TimeSpan.FromSeconds(8),
            });
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            var client = new MavlinkMissionClient(
                ScriptedVehicle.Companion(), ScriptedVehicle.Address,
                new MavlinkMissionOptions { Retries = lossPercent > 20 ? 25 : 5 });
            var random = new ProtocolRandom(seed);
            for (int transfer = 0; transfer < 6; transfer++)
            {
                var type = (MavMissionType)random.Below(3);
                MissionItemInt[] before = vehicle.Server.Items(type).ToArray();
                MissionItemInt[] items = ItemsOf(random, random.Below(40));
                Assert.True(client.TryStartUpload(type, items, world.Now));
                MavlinkMissionOutcome up = End(client, world);
                string context = $"{world.Context}, upload {transfer} of {items.Length} {type}: {up}";
                MissionItemInt[] after = vehicle.Server.Items(type).ToArray();
                bool isNew = IsSame(items, after);
                Assert.True(isNew || (IsSame(before, after) && up.Status != MavlinkMissionStatus.Done), context);
                Count(statuses, up.Status);

                Assert.True(client.TryStartDownload(type, world.Now));
                MavlinkMissionOutcome down = End(client, world);
                if (down.Status == MavlinkMissionStatus.Done)
                    Assert.True(IsSame(vehicle.Server.Items(type).ToArray(), client.Items.ToArray()), context);
                Count(statuses, down.Status);
            }

            Assert.True(client.TryStartClear(MavMissionType.All, world.Now));
            if (End(client, world).Status == MavlinkMissionStatus.Done)
                Assert.Equal(0, vehicle.Server.Items(MavMissionType.Fence).Length);
            Assert.Equal(0, vehicle.Server.Dropped);
        }

        output.WriteLine($"loss {lossPercent} %, ArduPilot {isArduPilot}, seeds 1 to 20: "
            + string.Join(", ", statuses.OrderBy(pair => pair.Key).Select(pair => $"{pair.Key} {pair.Value}")));
        if (lossPercent == 0)
            Assert.Equal(MavlinkMissionStatus.Done, Assert.Single(statuses).Key);
        Assert.True(statuses[MavlinkMissionStatus.Done] > 120);
    }

    private static MissionItemInt[] ItemsOf(ProtocolRandom random, int count)
    {
        var items = new MissionItemInt[count];
        for (int i = 0; i < count; i++)
            items[i] = new MissionItemInt { Command = MavCmd.NavWaypoint, X = random.Below(1000), Z = i };
        return items;
    }

    private static bool IsSame(MissionItemInt[] a, MissionItemInt[] b)
        => a.Select(item => (item.X, item.Z)).SequenceEqual(b.Select(item => (item.X, item.Z)));

    private static void Count(Dictionary<MavlinkMissionStatus, int> statuses, MavlinkMissionStatus status)
        => statuses[status] = statuses.TryGetValue(status, out int times) ? times + 1 : 1;

    private static MavlinkMissionOutcome End(MavlinkMissionClient client, ProtocolWorld world)
    {
        MavlinkMissionOutcome outcome = default;
        bool ended = world.RunUntil(
            () => client.TryTakeOutcome(out outcome), client.Handle, client.TryTakeFrame, () => client.NextDue,
            TimeSpan.FromSeconds(600));
        Assert.True(ended, world.Context);
        return outcome;
    }
}
