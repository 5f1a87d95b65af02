using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// Random commands of the operator in all phases, with takeovers and losses of the link: each is answered, the log is
/// complete, and no phase comes about that the tables do not have.
/// </summary>
public class OperatorSequenceTests(ITestOutputHelper output)
{
    private const int Sequences = 200;

    private static readonly OperatorCommand[] Commands = EnumValues.Of<OperatorCommand>();
    private static readonly MissionEvent[] Events = EnumValues.Of<MissionEvent>();

    [Fact]
    public void Commands_RandomSequencesInAllPhases_AreAnsweredAndTheLogIsComplete()
    {
        var seen = new HashSet<(MissionPhase, OperatorCommand)>();
        for (int seed = 1; seed <= Sequences; seed++)
        {
            using var rig = new MissionRig(MissionRig.Mission(), seed: seed);
            rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
            List<OperatorRequest> requests = Fly(rig, new Random(seed));
            try
            {
                Check(rig, requests, seen);
            }
            catch
            {
                output.WriteLine($"seed {seed}{Environment.NewLine}{rig.Story}");
                throw;
            }
        }

        foreach (MissionPhase phase in EnumValues.Of<MissionPhase>().Except([MissionPhase.NoMission]))
        {
            string answered = string.Join(", ", seen.Where(s => s.Item1 == phase).Select(s => s.Item2));
            output.WriteLine($"{phase}: {answered}");
            Assert.True(answered.Length > 0, $"nothing was answered in {phase}");
        }
    }

    private static List<OperatorRequest> Fly(MissionRig rig, Random random)
    {
        var requests = new List<OperatorRequest>();
        if (random.Next(4) > 0)
            rig.Run(random.Next(1, 120));
        for (int i = random.Next(3, 10); i > 0; i--)
        {
            Disturb(rig, random);
            for (int burst = random.Next(1, 4); burst > 0; burst--)
                requests.Add(Give(rig, random, requests.Count));
            rig.Run(random.NextDouble() * random.NextDouble() * 30);
        }

        rig.Vehicle.IsConnected = true;
        rig.Run(25);
        return requests;
    }

    private static void Disturb(MissionRig rig, Random random)
    {
        int what = random.Next(12);
        if (what == 0)
            rig.Vehicle.TakeOver("mode LOITER");
        rig.Vehicle.IsConnected = what != 1;
    }

    private static OperatorRequest Give(MissionRig rig, Random random, int number)
    {
        // Most of the time something that lets the flight go on.
        OperatorCommand command = random.Next(3) == 0
            ? OperatorCommand.Continue
            : Commands[random.Next(Commands.Length)];
        if (command is OperatorCommand.Land or OperatorCommand.Return && random.Next(2) == 0)
            command = OperatorCommand.Hold;
        var place = new NedPosition(random.Next(-100, 300), random.Next(-150, 150), 0);
        var request = new OperatorRequest(command, "test", "reason " + number)
        {
            TrackId = random.Next(1, 3),
            Place = LocalNedFrame.IgnoringGeoid(MissionRig.Home).ToGeodetic(place),
            SpeedMetresPerSecond = random.Next(-1, 23),
        };
        rig.Manager.Give(request);
        return request;
    }

    private static void Check(
        MissionRig rig, List<OperatorRequest> requests, HashSet<(MissionPhase, OperatorCommand)> seen)
    {
        Assert.All(requests, r => Assert.NotEqual(OperatorOutcome.InProgress, r.Outcome));
        Assert.All(requests.Where(r => r.Outcome == OperatorOutcome.Refused), r => Assert.NotEmpty(r.Answer));
        string[] log = [.. rig.Entries.Select(e => e.Text)];
        foreach (OperatorRequest request in requests)
            Assert.Single(log, l => l == $"operator test: {request.Name}, {request.Reason}");

        MissionPhase phase = MissionPhase.WaitingForVehicle;
        int answers = 0;
        foreach (string line in log)
        {
            if (OfTransition(line) is { } transition)
            {
                Assert.Equal(phase, transition.From);
                Assert.Contains(transition.To, Events.Select(e => MissionTransitions.After(transition.From, e)));
                phase = transition.To;
            }

            if (!line.StartsWith("operator test's ", StringComparison.Ordinal))
                continue;
            answers++;
            OperatorRequest answered = requests
                .First(r => line.StartsWith($"operator test's {r.Name} ", StringComparison.Ordinal));
            seen.Add((phase, answered.Command));
            bool isAccepted = line.StartsWith($"operator test's {answered.Name} accepted", StringComparison.Ordinal);
            if (isAccepted)
                Assert.Null(OperatorRules.FindRefusal(phase, answered.Command));
        }

        Assert.Equal(requests.Count, answers);
        Assert.Equal(phase, rig.Status.Phase);
    }

    private static (MissionPhase From, MissionPhase To)? OfTransition(string line)
    {
        int arrow = line.IndexOf(" -> ", StringComparison.Ordinal);
        int end = line.IndexOf(':');
        return arrow > 0 && end > arrow && Enum.TryParse(line.Substring(0, arrow), out MissionPhase from)
            && Enum.TryParse(line.Substring(arrow + 4, end - arrow - 4), out MissionPhase to)
                ? (from, to)
                : null;
    }
}
