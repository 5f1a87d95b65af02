using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Client and server, fifty commands over links that lose, double and reorder.</summary>
public class CommandServerLossTests(ITestOutputHelper output)
{
    private const int Commands = 50;
    private static readonly MavCmd[] Kinds =
        [MavCmd.DoPauseContinue, MavCmd.NavLand, MavCmd.MissionStart, MavCmd.DoChangeSpeed, MavCmd.User1];

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void FiftyCommands_ManySeeds_NoneExecutedTwice(int lossPercent)
    {
        var statuses = new Dictionary<MavlinkCommandStatus, int>();
        long repeats = 0;
        for (ulong seed = 1; seed <= 25; seed++)
        {
            var vehicle = new CommandServerVehicle();
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            var client = new MavlinkCommandClient(
                ScriptedVehicle.Companion(), new MavlinkCommandOptions { RetriesInProgress = true });
            var outcomes = new List<MavlinkCommandOutcome>();
            Dictionary<int, int> tokens = Start(client, world, new ProtocolRandom(seed));
            bool ended = world.RunUntil(
                () =>
                {
                    while (client.TryTakeOutcome(out MavlinkCommandOutcome outcome))
                        outcomes.Add(outcome);
                    return outcomes.Count == Commands;
                },
                client.Handle, client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(600));
            Assert.True(ended, $"{world.Context}: {outcomes.Count} of {Commands} ended");
            foreach (MavlinkCommandOutcome outcome in outcomes)
            {
                Check(outcome, tokens[outcome.Handle], vehicle, lossPercent, world.Context);
                statuses[outcome.Status] = statuses.TryGetValue(outcome.Status, out int count) ? count + 1 : 1;
            }

            Assert.Equal(0, vehicle.Server.Dropped);
            repeats += vehicle.Server.Repeats;
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to 25: "
            + $"{string.Join(", ", statuses.OrderBy(pair => pair.Key).Select(pair => $"{pair.Key} {pair.Value}"))}; "
            + $"{repeats} copies answered");
        Assert.Equal(lossPercent > 0, repeats > 0);
    }

    private static Dictionary<int, int> Start(MavlinkCommandClient client, ProtocolWorld world, ProtocolRandom random)
    {
        var tokens = new Dictionary<int, int>();
        for (int token = 1; token <= Commands; token++)
        {
            MavCmd kind = Kinds[random.Below(Kinds.Length)];
            int what = random.Below(6);
            MavlinkCommand command = random.Below(2) == 0
                ? MavlinkCommand.Create(ScriptedVehicle.Address, kind, token, what)
                : MavlinkCommand.AtLocation(ScriptedVehicle.Address, kind, MavFrame.Global, 1, 2, 3, token, what);
            Assert.True(client.TryStart(command, world.Now, out int handle));
            tokens.Add(handle, token);
            if (random.Below(15) == 0)
                client.Cancel(handle, world.Now);
        }

        return tokens;
    }

    private static void Check(
        in MavlinkCommandOutcome outcome, int token, CommandServerVehicle vehicle, int lossPercent, string context)
    {
        int kind = (int)outcome.Command.Param2;
        context += $", token {token}, kind {kind}: {outcome}";
        vehicle.Executions.TryGetValue(token, out int times);
        Assert.True(times <= 1, $"{context}: executed {times} times");
        if (outcome.Result is not null && outcome.Status != MavlinkCommandStatus.Cancelled)
            Assert.True(outcome.ResultParam2 == token, context);
        MavlinkCommandStatus expected = outcome.Sent == 0 ? MavlinkCommandStatus.Cancelled
            : kind is 1 or 5 ? MavlinkCommandStatus.Refused
            : MavlinkCommandStatus.Accepted;
        bool mayBeUnknown = lossPercent > 0 && outcome.Sent > 0;
        Assert.True(
            outcome.Status == expected || (mayBeUnknown && outcome.Status == MavlinkCommandStatus.Unknown), context);
        if (outcome.Status == MavlinkCommandStatus.Accepted)
            Assert.True(times == 1, context);
        if (outcome.Status == MavlinkCommandStatus.Cancelled)
            Assert.True(times == 0, context);
    }
}
