using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// Contract 1.9 where the kind of time matters: exact and repeatable in virtual time, on both wait engines in real
/// time.
/// </summary>
public sealed class StopDelayTests
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan Second = TimeSpan.FromSeconds(1);

    [Fact, Trait("Clause", "1.9"), Trait("Clause", "5.1")]
    public void Stop_DelayedInVirtualTime_EndsExactlyAtItsLimit()
    {
        RabitReactor reactor = NewReactor(new VirtualTime(), out ScriptedManager holder);
        holder.Period = TimeSpan.FromMilliseconds(400);
        reactor.Start();
        Assert.True(reactor.RunFor(Second));

        reactor.Stop();
        Assert.True(reactor.RunFor(Second));   // the delay: units of work go on
        Assert.False(reactor.RunFor(TimeSpan.FromSeconds(60)));
        ReactorResult result = reactor.Finish();

        Assert.Equal((Limit, Second + Limit), (result.StopDelay, result.Duration));
        Assert.Equal(["holder"], result.StillDelaying);

        // At 0, 0.4 ... 4.0 s, the last one at the limit, and at 1.0 s for the request.
        Assert.Equal(12, result.Managers[0].Runs);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_DelayedInVirtualTimeByOneThatHangs_EndsAtItsLimit()
    {
        var time = new VirtualTime();
        RabitReactor reactor = NewReactor(time, out ScriptedManager holder);
        holder.HangPolicy = HangPolicy.StopSystem.WithLimits(Second);
        time.AddLongUnitOfWork("holder", TimeSpan.Zero, TimeSpan.MaxValue);

        reactor.Start();
        ReactorResult result = reactor.Finish();

        Assert.Equal((Limit, Second + Limit), (result.StopDelay, result.Duration));
        Assert.Equal(["holder"], result.StillDelaying);
        Assert.Equal(1, result.Managers[0].HangCount);
    }

    /// <summary>
    /// Two managers that set and unset at random moments, a request at another, in many orders: the stop comes when
    /// the last one ends to delay, never before, and at once where none delays.
    /// </summary>
    [Fact, Trait("Clause", "1.9"), Trait("Clause", "5.2")]
    public void Stop_RacingWithDelays_HoldsInEveryOrderOfManySeeds()
    {
        int waited = 0;
        for (int seed = 1; seed <= 300; seed++)
        {
            ReactorResult first = RunRace(seed, out string events, out bool delays, out bool kept);
            Assert.True(kept, $"seed {seed}: the run stopped before a manager that was in time had finished");
            Assert.Equal(delays, events.Contains("StopRequested", StringComparison.Ordinal));
            Assert.Empty(first.StillDelaying);
            RunRace(seed, out string again, out _, out _);
            Assert.Equal(events, again);
            waited += delays ? 1 : 0;
        }

        Assert.InRange(waited, 30, 270);
    }

    [Theory, Trait("Clause", "1.9")]
    [InlineData(WaitEngine.Event)]
    [InlineData(WaitEngine.Futex)]
    public void Stop_DelayedOnEachWaitEngine_WaitsForTheManager(WaitEngine engine)
    {
        RabitReactor reactor = NewReactor(
            new RealTime { WaitEngine = engine }, out ScriptedManager holder, TimeSpan.FromMinutes(10));
        int delayed = 0;   // units of work after the request that the stop waited for; a late stop lets more follow
        holder.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        holder.OnUnit = () =>
        {
            if (holder.IsStopRequested && holder.DelaysStop && ++delayed == 5)
                holder.DelaysStop = false;
        };

        reactor.Start();
        reactor.Stop();
        ReactorResult result = reactor.Finish();

        Assert.Equal((5, 0), (delayed, result.ExitCode));
        Assert.Empty(result.StillDelaying);
    }

    [Fact, Trait("Clause", "1.9")]
    public async Task Stop_FromAnotherThreadWhilePacedTimeSleeps_IsDelayedAtOnce()
    {
        // An hour until the next timer, at real speed: only the limit, which is new, ends the wait.
        var time = new VirtualTime { Pace = 1 };
        RabitReactor reactor = NewReactor(time, out ScriptedManager holder, TimeSpan.FromMilliseconds(50));
        holder.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromHours(1), TimeSpan.FromHours(1));
        using var sleeps = new ManualResetEventSlim();
        holder.OnUnit = () =>
        {
            sleeps.Set();
            throw new InvalidOperationException("boom");
        };
        Task<ReactorResult> running = reactor.RunAsync();
        Assert.True(sleeps.Wait(TestTimeout.Limit));

        reactor.Stop();

        Assert.Equal(["holder"], (await running).StillDelaying);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Failure_OfTheRunItself_IsNeverDelayed()
    {
        RabitReactor reactor = NewReactor(new VirtualTime { MaxRunsPerInstant = 100 }, out ScriptedManager holder);
        holder.OnUnit = holder.WakeUp;

        reactor.Start();
        ReactorResult result = reactor.Finish();

        Assert.NotNull(result.Failure);
        Assert.Equal((TimeSpan.Zero, 1L), (result.StopDelay, (long)holder.Shutdowns));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(3601)]
    public void MaxStopDelay_OutOfRange_IsRefusedByName(int seconds)
    {
        var error = Assert.Throws<ArgumentException>(
            () => new RabitReactor(new ReactorOptions { MaxStopDelay = TimeSpan.FromSeconds(seconds) }));

        Assert.Contains("MaxStopDelay", error.Message, StringComparison.Ordinal);
    }

    private static ReactorResult RunRace(int seed, out string events, out bool delays, out bool kept)
    {
        var random = new Random(seed);
        var log = new StringWriter();
        var reactor = new RabitReactor(new ReactorOptions
        {
            Time = new VirtualTime(seed) { EventLog = log },
            MaxStopDelay = TimeSpan.FromHours(1),
            StopsOnSignals = false,
        });
        var board = new TestBoard();
        var inTime = new List<ScriptedManager>();   // set, and found no request after that
        bool isKept = true;
        for (int i = 0; i < 2; i++)
        {
            // All at whole milliseconds of the first five, so that they often meet.
            var manager = new ScriptedManager($"m{i}", board) { WakeUpDelay = TimeSpan.FromMilliseconds(1) };
            int sets = random.Next(1, 5);
            int unsets = sets + random.Next(0, 3);
            manager.OnUnit = () =>
            {
                if (manager.Units == sets)
                {
                    manager.DelaysStop = true;
                    if (!manager.IsStopRequested)
                        inTime.Add(manager);
                }

                if (manager.Units < unsets)
                    return;
                inTime.Remove(manager);
                manager.DelaysStop = false;
            };
            manager.OnShutdown = () => isKept &= inTime.Count == 0;
            reactor.Add(manager);
        }

        var stopper = new ScriptedManager("stopper", board) { WakeUpDelay = TimeSpan.FromMilliseconds(1) };
        int stops = random.Next(1, 6);
        bool isDelayed = false;
        stopper.OnUnit = () =>
        {
            if (stopper.Units != stops)
                return;
            isDelayed = inTime.Count > 0;
            stopper.StopAll("enough");
        };
        reactor.Add(stopper);
        reactor.Start();
        ReactorResult result = reactor.Finish();
        (events, delays, kept) = (log.ToString(), isDelayed, isKept);
        return result;
    }

    private static RabitReactor NewReactor(RabitTime time, out ScriptedManager holder, TimeSpan? limit = null)
    {
        holder = new ScriptedManager("holder", new TestBoard()) { DelaysStop = true };
        return new RabitReactor(
            new ReactorOptions { Time = time, MaxStopDelay = limit ?? Limit, StopsOnSignals = false })
        {
            holder,
        };
    }
}
