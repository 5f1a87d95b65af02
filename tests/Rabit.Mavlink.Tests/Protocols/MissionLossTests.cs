using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Missions of a hundred items up, down and cleared, over links that lose, double and reorder.</summary>
public class MissionLossTests(ITestOutputHelper output)
{
    private const int Count = 100;

    // On a link that loses 40 % the retries of the guide are too few for a hundred items; such a link needs other
    // options.
    private static readonly MavlinkMissionOptions ManyRetries = new() { Retries = 25 };

    [Theory]
    [MemberData(nameof(Cases))]
    public void UpDownClear_FewSeeds_CompletesOrFailsCleanly(int lossPercent, bool isArduPilot, bool hasManyRetries)
        => Run(lossPercent, isArduPilot, hasManyRetries, 5);

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(Cases))]
    public void UpDownClear_AllSeeds_CompletesOrFailsCleanly(int lossPercent, bool isArduPilot, bool hasManyRetries)
        => Run(lossPercent, isArduPilot, hasManyRetries, 200);

    public static TheoryData<int, bool, bool> Cases()
    {
        var cases = new TheoryData<int, bool, bool>();
        foreach (int loss in new[] { 0, 5, 20, 40 })
        {
            cases.Add(loss, false, false);
            cases.Add(loss, true, false);
            cases.Add(loss, false, true);
        }

        return cases;
    }

    [Fact]
    public void Upload_Refused_HasTheReason()
    {
        var vehicle = new MissionVehicle(isArduPilot: false) { Refuses = MavMissionResult.NoSpace };
        var world = new ProtocolWorld(vehicle, 0, 1);
        var client = new MavlinkMissionClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
        Assert.True(client.TryStartUpload(MavMissionType.Mission, Items(3, 1), world.Now));
        MavlinkMissionOutcome outcome = End(client, world, "");
        Assert.Equal((MavlinkMissionStatus.Refused, MavMissionResult.NoSpace), (outcome.Status, outcome.Result));
        Assert.True(client.TryStartUpload(MavMissionType.Fence, default, world.Now));
        Assert.Equal(MavlinkMissionStatus.Refused, End(client, world, "").Status);
    }

    [Fact]
    public void Cancel_HalfWay_NotifiesTheVehicle()
    {
        var vehicle = new MissionVehicle(isArduPilot: false);
        var world = new ProtocolWorld(vehicle, 0, 1);
        var client = new MavlinkMissionClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
        Assert.True(client.TryStartUpload(MavMissionType.Mission, Items(50, 1), world.Now));
        Assert.True(
            world.RunUntil(
                () => client.ItemsDone == 20, client.Handle, client.TryTakeFrame, () => client.NextDue,
                TimeSpan.FromSeconds(10)));
        Assert.False(client.TryStartDownload(MavMissionType.Mission, world.Now));
        client.Cancel(world.Now);
        Assert.Equal(MavlinkMissionStatus.Cancelled, End(client, world, "").Status);
        world.RunUntil(
            () => false, client.Handle, client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(0.2));
        Assert.Equal(TimeSpan.MaxValue, vehicle.NextDue);   // it asks no more
        Assert.Empty(vehicle[MavMissionType.Mission]);
    }

    private static MissionItemInt[] Items(int count, ulong seed)
    {
        var random = new ProtocolRandom(seed);
        var items = new MissionItemInt[count];
        for (int i = 0; i < count; i++)
            items[i] = new MissionItemInt
            {
                Command = MavCmd.NavWaypoint,
                X = (int)random.Next(),
                Y = (int)random.Next(),
                Z = random.Below(1000),
                Autocontinue = 1
            };
        return items;
    }

    private void Run(int lossPercent, bool isArduPilot, bool hasManyRetries, int seeds)
    {
        var statuses = new Dictionary<string, int>(StringComparer.Ordinal);
        double longest = 0;
        for (ulong seed = 1; seed <= (ulong)seeds; seed++)
        {
            var vehicle = new MissionVehicle(isArduPilot);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            var client = new MavlinkMissionClient(
                ScriptedVehicle.Companion(), ScriptedVehicle.Address, hasManyRetries ? ManyRetries : null);
            string context = world.Context;
            TimeSpan start = world.Now;
            var type = (MavMissionType)(seed % 3);
            MissionItemInt[] items = Items(Count, seed);

            Assert.True(client.TryStartUpload(type, items, world.Now));
            MavlinkMissionOutcome up = End(client, world, context);
            if (up.Status == MavlinkMissionStatus.Done)
                AssertSame(items, vehicle[type], context + " up");
            else
                AssertFailsCleanly(up, lossPercent, context);

            // Another mission than was uploaded: what is left of the upload must not pass for it.
            MissionItemInt[] others = Items(Count, seed + 1000);
            vehicle[type] = others.Select((item, index) => item with { Seq = (ushort)index, MissionType = type })
                .ToList();
            Assert.True(client.TryStartDownload(type, world.Now));
            MavlinkMissionOutcome down = End(client, world, context);
            if (down.Status == MavlinkMissionStatus.Done)
                AssertSame(others, client.Items.ToArray(), context + " down");
            else
                Assert.True(lossPercent > 0 && down.Status == MavlinkMissionStatus.Unknown, $"{context}: {down}");

            Assert.True(client.TryStartClear(type, world.Now));
            MavlinkMissionOutcome clear = End(client, world, context);
            if (clear.Status == MavlinkMissionStatus.Done)
                Assert.Empty(vehicle[type]);
            Add(statuses, $"up {up.Status}");
            Add(statuses, $"down {down.Status}");
            Add(statuses, $"clear {clear.Status}");
            longest = Math.Max(longest, (world.Now - start).TotalSeconds);
        }

        output.WriteLine($"loss {lossPercent} %, {(isArduPilot ? "ArduPilot" : "PX4")}, "
            + $"{(hasManyRetries ? "25" : "5")} retries, seeds 1 to {seeds}: "
            + $"{string.Join(", ", statuses.OrderBy(pair => pair.Key, StringComparer.Ordinal).Select(pair => $"{pair.Key} {pair.Value}"))}; longest {longest:F0} s");
        Assert.False(
            hasManyRetries
                && statuses.Keys.Any(key => key.StartsWith("down", StringComparison.Ordinal) && key != "down Done"),
            "a download with 25 retries never fails");
    }

    // A vehicle that has given the transfer up answers the next item with an error; INVALID_SEQUENCE to a copy is no
    // refusal.
    private static void AssertFailsCleanly(in MavlinkMissionOutcome up, int lossPercent, string context)
    {
        bool isGivenUp = up.Status == MavlinkMissionStatus.Refused && up.Result == MavMissionResult.Error;
        Assert.True(lossPercent > 0 && (isGivenUp || up.Status == MavlinkMissionStatus.Unknown), $"{context}: {up}");
    }

    private static void AssertSame(MissionItemInt[] expected, IReadOnlyList<MissionItemInt> actual, string context)
    {
        Assert.True(expected.Length == actual.Count, $"{context}: {actual.Count} items");
        for (int i = 0; i < expected.Length; i++)
            Assert.True(
                actual[i].Seq == i
                    && (expected[i].X, expected[i].Y, expected[i].Z) == (actual[i].X, actual[i].Y, actual[i].Z),
                $"{context}: item {i}");
    }

    private static void Add(Dictionary<string, int> statuses, string status)
        => statuses[status] = statuses.TryGetValue(status, out int count) ? count + 1 : 1;

    private static MavlinkMissionOutcome End(MavlinkMissionClient client, ProtocolWorld world, string context)
    {
        MavlinkMissionOutcome outcome = default;
        Assert.True(world.RunUntil(() => client.TryTakeOutcome(out outcome), client.Handle, client.TryTakeFrame, () =>
            client.NextDue, TimeSpan.FromSeconds(2000)), context + ": no outcome");
        Assert.False(client.TryTakeOutcome(out _), context);
        return outcome;
    }
}
