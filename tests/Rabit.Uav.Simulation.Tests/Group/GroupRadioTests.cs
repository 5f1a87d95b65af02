using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>
/// Three whole companion computers search 24 ha by pictures over a radio that loses 40 % of the frames, delivers some
/// of them twice and in another order, has bursts of losses, and separates one vehicle for 20 s.
/// </summary>
public sealed class GroupRadioTests(ITestOutputHelper output)
{
    private static readonly TimeSpan PartitionAt = TimeSpan.FromSeconds(150);
    private static readonly TimeSpan PartitionTime = TimeSpan.FromSeconds(20);

    // After that all know the same again.
    private static readonly TimeSpan HealTime = TimeSpan.FromSeconds(3);

    private static readonly TimeSpan Second = TimeSpan.FromSeconds(1);

    private readonly long[] _sent = new long[3];
    private TimeSpan _noted;

    [Theory, Trait("Category", "Long")]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    public void Flight_RadioIsBad_EachTargetHasOneValidatorAndNoneSendsMoreThanItMay(long seed)
    {
        using var flight = new CoverageFlight(3, seed, radio: Bad());
        var watch = new ValidatorWatch(flight.Flight);
        int[] most = new int[3];
        flight.Stepped = () =>
        {
            watch.Update();
            NoteMost(flight.Flight, most);
        };
        Assert.True(flight.Fly(), flight.Timeline());

        int budget = new SimulatedRadioOptions().BytesPerSecond / 3;
        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: seen {flight.Fraction:0.000}, found {flight.FoundByAny}, confirmed {flight.Confirmed}, false ")
            + FormattableString.Invariant($"{flight.FalseTracks}, most sent in a second {most.Max()} of {budget} ")
            + FormattableString.Invariant($"bytes, {watch.Awards.Count} awards, two validators for ")
            + FormattableString.Invariant($"at most {watch.MaxSeconds:0.0} s"));
        Assert.True(
            (flight.FoundByAny, flight.Confirmed, flight.FalseTracks) == (10, 10, 0),
            flight.Timeline() + flight.Flight.Log);
        Assert.True(flight.Fraction >= 0.98, flight.Timeline());
        Assert.True(watch.Faults.Count == 0, string.Join(Environment.NewLine, watch.Faults));
        Assert.True(watch.Awards.Count >= 5, flight.Timeline());
        Assert.Empty(flight.Flight.Group.TooNear);
        Assert.All(most, bytes => Assert.InRange(bytes, 100, budget));
        for (int i = 0; i < most.Length; i++)
        {
            RadioCounters radio = flight.Flight.Group.RadioOf(i);
            Assert.InRange(radio.LostAtRandom, 0.3 * radio.FramesSent, 2 * radio.FramesSent);
            Assert.All(
                [radio.LostByPartition, radio.LostInBursts, radio.Duplicated], n => Assert.InRange(n, 20, 10_000));
        }
    }

    [Theory, Trait("Category", "Long")]
    [InlineData(1)]
    [InlineData(2)]
    public void Flight_RadioIsBadAndOneVehicleIsLost_TheOthersSeeTheArea(long seed)
    {
        using var flight = new CoverageFlight(
            3, seed, radio: Bad(),
            faults: new SimulatedGroupFault(1, SimulatedGroupFaultKind.Lost, TimeSpan.FromSeconds(90)));
        Assert.True(flight.Fly(), flight.Timeline());
        Assert.True(flight.Fraction >= 0.98, flight.Timeline());
        Assert.All(
            new[] { 0, 2 }, i => Assert.True(
                flight.Flight.Mission(i).Result.Outcome == MissionOutcome.Accomplished, flight.Flight.LogOf(i)));
    }

    private static SimulatedRadioOptions Bad() => new()
    {
        Loss = 0.4,
        DuplicateFraction = 0.05,
        Jitter = TimeSpan.FromSeconds(0.1),
        BurstsPerSecond = 0.02,
        Partitions = [new RadioPartition(PartitionAt, PartitionTime, [2])],
    };

    // Of each whole second.
    private void NoteMost(GroupFlight flight, int[] most)
    {
        if (flight.Group.Now - _noted < Second)
            return;
        _noted = flight.Group.Now;
        for (int i = 0; i < most.Length; i++)
        {
            long sent = flight.Group.RadioOf(i).BytesSent;
            most[i] = Math.Max(most[i], (int)(sent - _sent[i]));
            _sent[i] = sent;
        }
    }

    /// <summary>Who takes a target for its own to validate.</summary>
    private sealed class ValidatorWatch(GroupFlight flight)
    {
        private readonly Dictionary<(byte Finder, ushort Number), TimeSpan> _since = [];

        public List<string> Faults { get; } = [];

        public double MaxSeconds { get; private set; }

        /// <summary>Awards that vehicles knew to be theirs.</summary>
        public HashSet<(byte Finder, ushort Number)> Awards { get; } = [];

        public void Update()
        {
            TimeSpan now = flight.Group.Now;
            bool isApart = now >= PartitionAt && now < PartitionAt + PartitionTime + HealTime;
            IGrouping<(byte, ushort), ValidationTask>[] awarded = Enumerable.Range(0, 3)
                .Where(i => flight.Group.Vehicles[i].HasStarted)
                .SelectMany(i => flight.GroupStatus(i).Validations.Where(
                    t => t.State == ValidationState.Awarded && t.Validator == i + 1))
                .GroupBy(t => (t.Finder, t.Number)).ToArray();
            Awards.UnionWith(awarded.Select(g => g.Key));
            var two = awarded.Where(g => g.Count() > 1).Select(g => g.Key).ToHashSet();
            foreach ((byte, ushort) over in _since.Keys.Where(k => !two.Contains(k)).ToArray())
                _since.Remove(over);
            foreach ((byte Finder, ushort Number) task in two)
            {
                if (isApart || !_since.TryGetValue(task, out TimeSpan since))
                    _since[task] = since = now;
                MaxSeconds = Math.Max(MaxSeconds, (now - since).TotalSeconds);
                if (now - since > HealTime)
                    Faults.Add(FormattableString.Invariant($"{now}: target {task.Number} of vehicle {task.Finder}"));
            }
        }
    }
}
