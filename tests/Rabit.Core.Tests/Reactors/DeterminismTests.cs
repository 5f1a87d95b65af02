using System;
using System.Diagnostics;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Reactors;

/// <summary>Contract 5.2: one seed, one run, to the byte.</summary>
public sealed class DeterminismTests(ITestOutputHelper output)
{
    [Fact, Trait("Clause", "5.2")]
    public void SameSeed_FiveMinutesOfMission_GivesTheSameLogToTheByte()
    {
        string first = Run(seed: 7, TimeSpan.FromMinutes(5), out long lines);

        Assert.Equal(first, Run(seed: 7, TimeSpan.FromMinutes(5), out long again));
        Assert.Equal(lines, again);
    }

    [Fact, Trait("Clause", "5.2")]
    public void SameMissionInSteps_SameSeed_GivesTheSameOrder()
    {
        Assert.Equal(Order(seed: 11, steps: 1), Order(seed: 11, steps: 1));
        Assert.Equal(Order(seed: 11, steps: 1), Order(seed: 11, steps: 40));
    }

    [Fact, Trait("Clause", "5.2")]
    public void OtherSeed_SameMission_GivesAnotherLegalOrder()
    {
        string first = Order(seed: 1, steps: 1);
        bool differs = false;
        for (int seed = 2; seed < 6; seed++)
        {
            string other = Order(seed, steps: 1);
            differs |= !string.Equals(first, other, StringComparison.Ordinal);

            // Legal: every manager has run at every instant it was due, whatever the order among them.
            Assert.Equal(first.Length, other.Length);
        }

        Assert.True(differs);
    }

    /// <summary>
    /// Two hours of mission, one after the other, in a minute of real time on any machine; seconds on a usual one.
    /// </summary>
    [Fact, Trait("Clause", "5.2"), Trait("Category", "Long")]
    public void SameSeed_AnHourOfMission_GivesTheSameLogToTheByteInSeconds()
    {
        var real = Stopwatch.StartNew();
        string first = Run(seed: 7, TimeSpan.FromHours(1), out long lines);
        output.WriteLine($"an hour with {lines} lines of log took {real.Elapsed}");

        Assert.Equal(first, Run(seed: 7, TimeSpan.FromHours(1), out _));
        Assert.True(lines > 6 * 50 * 3600);
        Assert.True(real.Elapsed < TimeSpan.FromMinutes(1), $"two hours took {real.Elapsed}");
    }

    private static string Run(long seed, TimeSpan duration, out long lines)
    {
        using var mission = new Mission(new VirtualTime(seed));
        string hash = mission.Run(duration);
        lines = mission.Lines;
        return hash;
    }

    private static string Order(long seed, int steps)
    {
        var order = new System.Text.StringBuilder();
        var reactor = new RabitReactor(new ReactorOptions { Time = new VirtualTime(seed), StopsOnSignals = false });
        for (char name = 'a'; name < 'g'; name++)
            reactor.Add(new Ticker(name, order));
        reactor.Start();
        for (int i = 0; i < steps; i++)
            reactor.RunFor(TimeSpan.FromTicks(TimeSpan.FromSeconds(4).Ticks / steps));
        reactor.Stop();
        reactor.Finish();
        return order.ToString();
    }

    private sealed class Ticker : RabitManager
    {
        private readonly char _name;
        private readonly System.Text.StringBuilder _order;

        public Ticker(char name, System.Text.StringBuilder order)
            : base(name.ToString())
        {
            _name = name;
            _order = order;
            WakeUpDelay = TimeSpan.FromMilliseconds(20);
        }

        protected override void ExecuteUnitOfWork() => _order.Append(_name);
    }
}
