using System;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Predecessors;

/// <summary>
/// What clocks and statistics of the predecessors got wrong; the numbers are those of docs/concepts/predecessors.md.
/// </summary>
public sealed class ClockDefectTests
{
    // There: one clock for the whole process, which any part could set.
    [Fact, Trait("Defect", "26")]
    public void Clock_OfTwoReactors_AreTwo()
    {
        var early = new RabitReactor(new VirtualTime());
        var late = new RabitReactor(new VirtualTime()) { new Sleeper("m") };

        late.Start();
        late.RunFor(TimeSpan.FromHours(1));
        late.Stop();
        late.Finish();

        Assert.Equal((TimeSpan.Zero, TimeSpan.FromHours(1)), (early.Now, late.Now));
    }

    // There: durations of seven digits, zero taken for "none yet", and no mean after the first cycle.
    [Fact, Trait("Defect", "27")]
    public void Statistics_ZeroFirstThenLong_AreExact()
    {
        DurationStatistics statistics = default(DurationStatistics).With(TimeSpan.Zero);
        Assert.Equal((1L, TimeSpan.Zero, TimeSpan.Zero), (statistics.Count, statistics.Min, statistics.Mean));

        statistics = statistics.With(TimeSpan.FromTicks(864_000_000_001));

        Assert.Equal((TimeSpan.Zero, TimeSpan.FromTicks(864_000_000_001)), (statistics.Min, statistics.Max));
        Assert.Equal(TimeSpan.FromTicks(432_000_000_000), statistics.Mean);
    }

    private sealed class Sleeper(string name) : RabitManager(name)
    {
        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
