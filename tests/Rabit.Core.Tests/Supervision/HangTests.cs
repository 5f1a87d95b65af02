using System;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Contract 1.6: a manager that does not stop in time is named, with what it is doing; the others end all the same.
/// </summary>
public sealed class HangTests
{
    // Short for the one that hangs, long for the others, who must end within it on a busy machine.
    private static readonly TimeSpan ShortTimeout = TimeSpan.FromSeconds(1);

    [Theory, Trait("Clause", "1.6")]
    [InlineData(ManagerStage.Startup, "m: Startup")]
    [InlineData(ManagerStage.UnitOfWork, "m: ExecuteUnitOfWork")]
    [InlineData(ManagerStage.Shutdown, "m: Shutdown")]
    public void Manager_ThatHangs_IsNamedWithWhatItDoesAndTheOthersEnd(ManagerStage stage, string expected)
    {
        using var release = new ManualResetEventSlim();
        using var run = new TestRun(TimeKind.Real, options => options.StopTimeout = ShortTimeout);
        ScriptedManager other = run.Add("other");
        ScriptedManager hanging = run.Add("m");
        void Hang()
        {
            run.Board.Write("hangs");
            run.Reactor.Stop("it hangs");
            release.Wait();
        }

        if (stage == ManagerStage.Startup)
            hanging.OnStartup = Hang;
        else if (stage == ManagerStage.UnitOfWork)
            hanging.OnUnit = Hang;
        else
            hanging.OnShutdown = Hang;

        run.Start();
        if (stage == ManagerStage.UnitOfWork)
            run.Until(() => run.Board.Count("hangs") == 1, "it hangs");
        ReactorResult result = stage == ManagerStage.Shutdown ? run.Finish() : run.FinishByItself();
        release.Set();

        ManagerResult named = result.Managers[1];
        Assert.Equal(1, result.ExitCode);
        Assert.Equal(ManagerOutcome.DidNotStop, named.Outcome);
        Assert.Equal(expected, Assert.Single(named.NotStopped));
        Assert.Contains(expected, named.ToString(), StringComparison.Ordinal);
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal(1, other.Shutdowns);
        Assert.Contains(run.Log, e => e.Text.Contains(expected, StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.6")]
    public void Unit_InProgressAtTheStop_FinishesBeforeShutdown()
    {
        using var release = new ManualResetEventSlim();
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = () =>
        {
            run.Board.Write("begins");
            release.Wait();
            run.Board.Write("ends");
        };
        manager.OnShutdown = () => run.Board.Write("shutdown");

        run.Start();
        run.Until(() => run.Board.Count("begins") == 1, "the unit begins");
        var finish = new Thread(() => run.Finish());
        finish.Start();
        run.Until(() => manager.WakeUpEvent.StopRequested, "the stop reaches the manager");
        release.Set();
        Assert.True(finish.Join(TestTimeout.Limit));

        Assert.Equal(["begins", "ends", "shutdown"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "1.6")]
    public void Stop_AtAnyMomentOfTheStart_EveryStartupHasItsShutdown()
    {
        const int Seed = 4711;
        const int Rounds = 200;
        var random = new Random(Seed);
        int startups = 0;
        int shutdowns = 0;
        int notStarted = 0;
        for (int round = 0; round < Rounds; round++)
        {
            int spins = random.Next(6000);
            using var go = new ManualResetEventSlim();
            using var run = new TestRun(TimeKind.Real);
            for (int i = 0; i < 4; i++)
            {
                ScriptedManager manager = run.Add("m" + i);
                manager.OnStartup = () =>
                {
                    go.Set();
                    Interlocked.Increment(ref startups);
                };
                manager.OnShutdown = () => Interlocked.Increment(ref shutdowns);
            }

            var stopper = new Thread(() =>
            {
                go.Wait();
                Thread.SpinWait(spins);
                run.Reactor.Stop();
            });
            stopper.Start();
            run.Start();
            ReactorResult result = run.FinishByItself();
            Assert.True(stopper.Join(TestTimeout.Limit));
            notStarted += result.Managers.Count(m => m.Outcome == ManagerOutcome.NotStarted);
        }

        // A manager that is not started never starts later, and one that started is shut down: the sums agree.
        Assert.Equal((Rounds * 4) - notStarted, Volatile.Read(ref startups));
        Assert.True(startups == shutdowns, $"seed {Seed}: {startups} startups, {shutdowns} shutdowns");
    }
}
