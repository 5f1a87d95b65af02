using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Fifty commands, several of a kind, over links that lose, double and reorder.</summary>
public class CommandLossTests(ITestOutputHelper output)
{
    private const int Commands = 50;
    private static readonly MavCmd[] Kinds =
        [MavCmd.ComponentArmDisarm, MavCmd.NavTakeoff, MavCmd.DoSetMode, MavCmd.DoReposition, MavCmd.RequestMessage];

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void FiftyCommands_FewSeeds_OneOutcomeEach(int lossPercent) => Run(lossPercent, 10);

    [Theory, Trait("Category", "Long")]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void FiftyCommands_AllSeeds_OneOutcomeEach(int lossPercent) => Run(lossPercent, 200);

    private void Run(int lossPercent, int seeds)
    {
        var statuses = new Dictionary<MavlinkCommandStatus, int>();
        int duplicates = 0;
        double longest = 0;
        for (ulong seed = 1; seed <= (ulong)seeds; seed++)
        {
            var vehicle = new CommandVehicle();
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            var client = new MavlinkCommandClient(ScriptedVehicle.Companion());
            var outcomes = new Dictionary<int, MavlinkCommandOutcome>();
            var tokens = new Dictionary<int, int>();
            var random = new ProtocolRandom(seed);
            TimeSpan start = world.Now;
            for (int token = 1; token <= Commands; token++)
            {
                var command = MavlinkCommand.Create(
                    ScriptedVehicle.Address, Kinds[random.Below(Kinds.Length)], token, random.Below(6));
                Assert.True(client.TryStart(command, world.Now, out int handle));
                tokens.Add(handle, token);
                if (random.Below(15) == 0)
                    client.Cancel(handle, world.Now);
            }

            bool ended = world.RunUntil(
                () => Collect(client, outcomes), client.Handle, client.TryTakeFrame, () => client.NextDue,
                TimeSpan.FromSeconds(600));
            string context = world.Context;
            Assert.True(ended, $"{context}: {outcomes.Count} of {Commands} ended");
            foreach (MavlinkCommandOutcome outcome in outcomes.Values)
                Check(outcome, tokens[outcome.Handle], vehicle, lossPercent, context);
            foreach (MavlinkCommandOutcome outcome in outcomes.Values)
                statuses[outcome.Status] = statuses.TryGetValue(outcome.Status, out int count) ? count + 1 : 1;

            // What is still on its way changes nothing any more.
            world.RunUntil(
                () => false, client.Handle, client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(10));
            Assert.False(client.TryTakeOutcome(out _), context);
            duplicates += vehicle.Duplicates;
            longest = Math.Max(longest, (world.Now - start).TotalSeconds);
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to {seeds}: "
            + $"{string.Join(", ", statuses.OrderBy(pair => pair.Key).Select(pair => $"{pair.Key} {pair.Value}"))}; "
            + $"{duplicates} copies reached the vehicle, longest {longest:F0} s");
    }

    private static bool Collect(MavlinkCommandClient client, Dictionary<int, MavlinkCommandOutcome> outcomes)
    {
        while (client.TryTakeOutcome(out MavlinkCommandOutcome outcome))
            outcomes.Add(outcome.Handle, outcome);   // throws at a second one
        return outcomes.Count == Commands;
    }

    private static void Check(
        in MavlinkCommandOutcome outcome, int token, CommandVehicle vehicle, int lossPercent, string context)
    {
        int kind = (int)outcome.Command.Param2;
        context += $", token {token}, kind {kind}: {outcome}";
        Assert.True(outcome.Sent <= 4 * (1 + 3 + 1), context);

        // The vehicle hands the token back: no other command's answer was taken.
        if (outcome.Result is not null)
            Assert.True(outcome.ResultParam2 == token, context);
        MavlinkCommandStatus expected = outcome.Sent == 0 ? MavlinkCommandStatus.Cancelled
            : kind == 1 ? MavlinkCommandStatus.Refused
            : kind == 5 ? MavlinkCommandStatus.Unknown
            : MavlinkCommandStatus.Accepted;
        bool mayBeUnknown = lossPercent > 0 && outcome.Sent > 0;
        Assert.True(
            outcome.Status == expected || (mayBeUnknown && outcome.Status == MavlinkCommandStatus.Unknown), context);
        if (outcome.Status == MavlinkCommandStatus.Accepted)
            Assert.True(vehicle.Executions.TryGetValue(token, out int times) && times == 1, context);
        if (outcome.Status == MavlinkCommandStatus.Cancelled)
            Assert.False(vehicle.Executions.ContainsKey(token), context);
    }
}
