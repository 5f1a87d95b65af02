using System;
using System.Collections.Generic;
using Xunit;

namespace Rabit.Core.Tests.Time;

/// <summary>Contract 5.2: bugs of order are searched by seeds.</summary>
public sealed class SeedSearchTests
{
    [Fact, Trait("Clause", "5.2")]
    public void Find_AnOrderThatOneOfFourSeedsHas_NamesASeedThatFailsEachTime()
    {
        FailingSeed? found = SeedSearch.Find(firstSeed: 1, count: 100, RunRace);

        Assert.NotNull(found);
        Assert.Equal("b came first twice", found.Failure.Message);
        Assert.Equal($"seed {found.Seed} fails: b came first twice", found.ToString());
        Assert.Throws<OrderException>(() => RunRace(new VirtualTime(found.Seed)));
        Assert.Null(found.Seed == 1 ? null : SeedSearch.Find(1, (int)(found.Seed - 1), RunRace));
    }

    [Fact, Trait("Clause", "5.2")]
    public void Find_NothingFails_RunsEverySeedOnce()
    {
        var seeds = new List<long>();

        Assert.Null(SeedSearch.Find(firstSeed: -1, count: 4, time => seeds.Add(time.Seed)));

        Assert.Equal([-1, 0, 1, 2], seeds);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Find_FailureThatDoesNotComeAgain_SaysSo()
    {
        int runs = 0;
        var error = Assert.Throws<InvalidOperationException>(() => SeedSearch.Find(7, 10, _ =>
        {
            if (++runs == 1)
                throw new OrderException("once");
        }));

        Assert.Contains("Seed 7", error.Message, StringComparison.Ordinal);
        Assert.Equal("once", error.InnerException!.Message);
    }

    [Fact]
    public void Find_WithoutSeeds_IsRefused()
        => Assert.Throws<ArgumentOutOfRangeException>(() => SeedSearch.Find(1, 0, _ => { }));

    private static void RunRace(VirtualTime time)
    {
        string order = string.Empty;
        var reactor = new RabitReactor(time)
        {
            new Runner("a", () => order += "a"),
            new Runner("b", () => order += "b")
        };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromMilliseconds(10));
        reactor.Stop();
        reactor.Finish();
        if (string.Equals(order, "baba", StringComparison.Ordinal))
            throw new OrderException("b came first twice");
    }

    private sealed class Runner : RabitManager
    {
        private readonly Action _work;

        public Runner(string name, Action work)
            : base(name)
        {
            _work = work;
            Period = TimeSpan.FromMilliseconds(10);
        }

        protected override void ExecuteUnitOfWork() => _work();
    }

    private sealed class OrderException(string message) : Exception(message);
}
