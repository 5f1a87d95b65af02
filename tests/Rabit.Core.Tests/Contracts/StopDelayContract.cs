using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.9: a manager delays a requested stop, within a limit.</summary>
public abstract class StopDelayContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan Hour = TimeSpan.FromHours(1);
    private static readonly TimeSpan Short = TimeSpan.FromMilliseconds(30);

    [Fact, Trait("Clause", "1.9")]
    public void Stop_WhileAManagerDelays_WakesAllOnceWithTheCauseAndWaits()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        run.StartAndSettle();

        run.Reactor.Stop("first");
        run.Until(() => run.StatusOf(holder).Runs == 2 && run.StatusOf(other).Runs == 2, "both were woken");

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.StopRequested], holder.Causes);
        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.StopRequested], other.Causes);
        Assert.True(holder.IsStopRequested && other.IsStopRequested);
        Assert.Equal((0, 0), (holder.Shutdowns, other.Shutdowns));

        run.On(holder, () => holder.DelaysStop = false);
        ReactorResult result = run.FinishByItself();

        Assert.Equal(("first", 0), (result.StopReason, result.ExitCode));
        Assert.Empty(result.StillDelaying);
        Assert.Contains(
            run.Log, e => e.Text.StartsWith("is to stop: first; waits 3600.000 s", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_WhileAManagerDelays_AllContinueWithUnitsOfWork()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        QueueSender<int> asks = holder.Send<int>("asks");
        QueueReceiver<int> asked = other.Receive<int>("asks");
        QueueSender<int> answers = other.Send<int>("answers");
        QueueReceiver<int> answered = holder.Receive<int>("answers");
        int rounds = 0;
        holder.OnUnit = () =>
        {
            if (!holder.IsStopRequested)
                return;
            if (answered.TryPop(out int answer))
                rounds = answer;
            if (rounds < 10)
                asks.Push(rounds + 1);
            else
                holder.DelaysStop = false;
        };
        other.OnUnit = () =>
        {
            if (asked.TryPop(out int number))
                answers.Push(number);
        };

        run.StartAndSettle();
        run.Reactor.Stop();
        ReactorResult result = run.FinishByItself();

        Assert.Equal((10, 0), (rounds, result.ExitCode));
        Assert.All(result.Managers, m => Assert.Equal(ManagerOutcome.Ended, m.Outcome));
    }

    [Theory, Trait("Clause", "1.9"), Trait("Clause", "1.6")]
    [InlineData(true, 0)]
    [InlineData(false, 3600)]
    public void Stop_WithoutADelayOrWithoutTimeForOne_CausesNoExtraRun(bool delays, int seconds)
    {
        using TestRun run = NewDelayingRun(TimeSpan.FromSeconds(seconds), out ScriptedManager manager);
        ScriptedManager other = run.Add("other");
        run.StartAndSettle();
        run.OnAndSettle(manager, () => manager.DelaysStop = delays);

        run.Reactor.Stop();
        ReactorResult result = run.FinishByItself();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request], manager.Causes);
        Assert.Equal([WakeUpCauses.Start], other.Causes);
        Assert.Equal((TimeSpan.Zero, 0), (result.StopDelay, result.ExitCode));
        Assert.Empty(result.StillDelaying);
        Assert.True(manager.IsStopRequested);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_DelayBeyondItsLimit_ContinuesAndNamesTheManager()
    {
        using TestRun run = NewDelayingRun(Short, out ScriptedManager _);
        run.Add("other");
        run.StartAndSettle();

        run.Reactor.Stop();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(["holder"], result.StillDelaying);
        Assert.True(result.StopDelay >= Short && result.StopDelay <= result.Duration);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("did not wait for holder", result.ToString(), StringComparison.Ordinal);
        Assert.All(result.Managers, m => Assert.Equal(ManagerOutcome.Ended, m.Outcome));
        Assert.Contains(
            run.Log, e => e.Text.EndsWith("s, its limit, and waits no longer for holder", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_OneManagerDelaysNoLongerAndOneToTheLimit_OnlyThatOneIsNamed()
    {
        using TestRun run = NewDelayingRun(Short, out ScriptedManager _);
        ScriptedManager other = run.Add("other");
        run.StartAndSettle();
        run.OnAndSettle(other, () => other.DelaysStop = true);
        run.OnAndSettle(other, () => other.DelaysStop = false);

        run.Reactor.Stop();

        Assert.Equal(["holder"], run.FinishByItself().StillDelaying);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_RequestedAgainFromOutside_EndsTheDelay()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        run.StartAndSettle();
        run.Reactor.Stop("first");
        run.Until(() => run.StatusOf(holder).Runs == 2, "it was woken");

        ReactorResult result = run.Finish("second");

        Assert.Equal("first", result.StopReason);
        Assert.Equal(["holder"], result.StillDelaying);
        Assert.Equal((1, 1), (result.ExitCode, holder.Shutdowns));
        Assert.Contains(
            run.Log, e => e.Text.EndsWith("requested again and waits no longer for holder", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_RequestedByManagersAgain_EndsNoDelay()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        ScriptedManager faulty = run.Add("faulty");
        run.StartAndSettle();

        run.On(other, () => other.StopAll("enough"));
        run.OnAndSettle(other, () => other.StopAll("enough, really"));
        faulty.OnUnit = () => throw new InvalidOperationException("boom");
        faulty.WakeUp();
        run.Until(() => run.StatusOf(faulty).State == ManagerState.Faulted, "it throws");
        run.OnAndSettle(holder, () => holder.DelaysStop = false);
        ReactorResult result = run.FinishByItself();

        Assert.Equal("other: enough", result.StopReason);
        Assert.Empty(result.StillDelaying);
        Assert.True(result.StopDelay >= TimeSpan.Zero);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_ByAFaultWhileAnotherDelays_WaitsAndTheFaultyOneRunsNoMore()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager faulty = run.Add("faulty");
        run.StartAndSettle();
        faulty.OnUnit = () => throw new InvalidOperationException("boom");

        faulty.WakeUp();
        run.Until(() => holder.Causes.Contains(WakeUpCauses.StopRequested), "the fault requests a stop");
        faulty.WakeUp();
        run.OnAndSettle(holder, () => { });
        run.OnAndSettle(holder, () => holder.DelaysStop = false);
        ReactorResult result = run.FinishByItself();

        Assert.Equal(2, faulty.Units);
        Assert.Empty(result.StillDelaying);
        Assert.Equal((ManagerOutcome.Faulted, 1), (result.Managers[1].Outcome, result.ExitCode));
    }

    [Theory, Trait("Clause", "1.9")]
    [InlineData(false)]
    [InlineData(true)]
    public void Stop_TheDelayingManagerFaults_WaitsForItNoLonger(bool isRequested)
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        run.StartAndSettle();
        holder.OnUnit = () => throw new InvalidOperationException("boom");
        holder.OnShutdown = () => holder.DelaysStop = true;   // too late

        if (isRequested)
            run.Reactor.Stop("first");
        else
            holder.WakeUp();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(2, holder.Units);
        Assert.False(holder.DelaysStop);
        Assert.Empty(result.StillDelaying);
        Assert.Equal(isRequested, result.StopReason == "first");
        Assert.InRange(other.Units, 1, isRequested ? 2 : 1);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_TheDelayingManagerWasStoppedAlone_DoesNotWait()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        holder.FaultPolicy = FaultPolicy.StopManager;
        run.StartAndSettle();
        holder.OnUnit = () => throw new InvalidOperationException("boom");
        holder.WakeUp();
        run.Until(() => holder.Shutdowns == 1, "it is stopped alone");

        run.Reactor.Stop();
        ReactorResult result = run.FinishByItself();

        Assert.Equal([WakeUpCauses.Start], other.Causes);
        Assert.Equal(TimeSpan.Zero, result.StopDelay);
        Assert.Equal(ManagerOutcome.StoppedAlone, result.Managers[0].Outcome);
    }

    [Theory, Trait("Clause", "1.9")]
    [InlineData(FaultAction.CarryOn)]
    [InlineData(FaultAction.Restart)]
    public void Stop_TheDelayingManagerThrowsAndRunsAgain_IsWaitedFor(FaultAction action)
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        holder.FaultPolicy = action == FaultAction.CarryOn
            ? FaultPolicy.CarryOnAfter(Short, Short)
            : FaultPolicy.RestartAfter(Short, Short, 5, Hour);
        holder.OnUnit = () =>
        {
            if (holder.Units == 2)
                throw new InvalidOperationException("once");
            if (holder.Units > 2)
                holder.DelaysStop = false;
        };
        run.StartAndSettle();

        run.Reactor.Stop();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(3, holder.Units);
        Assert.Empty(result.StillDelaying);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_BeforeTheBarrierOpens_IsNotDelayed()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager stopper = run.Add("stopper");
        stopper.OnStartup = () => stopper.StopAll("at once");

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal((0, 1), (holder.Units, holder.Shutdowns));
        Assert.Equal((TimeSpan.Zero, 0), (result.StopDelay, result.ExitCode));
    }

    [Fact, Trait("Clause", "1.9")]
    public void DelaysStop_SetWhenTheRunStops_DelaysNothing()
    {
        using var run = new TestRun(Kind);
        ScriptedManager manager = run.Add("m");
        manager.OnShutdown = () => manager.DelaysStop = true;
        run.StartAndSettle();

        ReactorResult result = run.Finish();

        Assert.Equal((TimeSpan.Zero, 0), (result.StopDelay, result.ExitCode));
        Assert.False(manager.IsDelaying);
    }

    [Fact, Trait("Clause", "1.9")]
    public void DelaysStop_SetOnAnotherThread_IsRefused()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        run.StartAndSettle();

        var outside = Assert.Throws<InvalidOperationException>(() => holder.DelaysStop = false);
        var inside = Assert.Throws<InvalidOperationException>(() => run.On(other, () => holder.DelaysStop = false));

        Assert.Equal(
            "DelaysStop belongs to manager 'holder', but no manager is running on this thread.", outside.Message);
        Assert.Contains("but manager 'other' is running", inside.Message, StringComparison.Ordinal);
        run.OnAndSettle(holder, () => holder.DelaysStop = false);
    }

    [Fact, Trait("Clause", "1.9")]
    public void DelaysStop_SetDuringTheDelayOfAnother_Counts()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        ScriptedManager other = run.Add("other");
        run.StartAndSettle();
        run.Reactor.Stop();

        run.OnAndSettle(other, () => other.DelaysStop = true);
        run.OnAndSettle(holder, () => holder.DelaysStop = false);
        run.OnAndSettle(other, () => Assert.Equal(0, holder.Shutdowns));
        run.OnAndSettle(other, () => other.DelaysStop = false);
        ReactorResult result = run.FinishByItself();

        Assert.Equal(0, result.ExitCode);
    }

    [Fact, Trait("Clause", "1.9")]
    public void Stop_WhileAManagerDelays_IsKnownToItsReaders()
    {
        using TestRun run = NewDelayingRun(Hour, out ScriptedManager holder);
        var source = new StopAwareSource();
        BlockingReader<bool> reader = holder.AttachReader("line", source);
        var read = new List<bool>();
        holder.OnUnit = () =>
        {
            while (reader.TryPop(out bool value))
                read.Add(value);
        };
        run.StartAndSettle();
        run.Until(() => source.IsOpen, "it is opened, on a thread of its own");
        source.Ask();
        run.Until(() => read.Count == 1, "it was asked once");

        run.Reactor.Stop();
        source.Ask();
        run.Until(() => read.Count == 2, "it was asked again");
        run.On(holder, () => holder.DelaysStop = false);

        Assert.Equal(0, run.FinishByItself().ExitCode);
        Assert.Equal([false, true], read);
    }

    private TestRun NewDelayingRun(TimeSpan limit, out ScriptedManager holder)
    {
        TestRun run = NewRun(options => options.MaxStopDelay = limit);
        ScriptedManager manager = holder = run.Add("holder");
        manager.DelaysStop = true;   // as from the constructor
        return run;
    }

    /// <summary>Gives, as often as it is asked, whether a stop is requested.</summary>
    private sealed class StopAwareSource : IReaderSource<bool>
    {
        private volatile ReaderContext? _context;   // written by the reader's thread
        private int _asked;

        public bool Blocks => false;

        public bool IsOpen => _context is not null;

        public void Open(ReaderContext context) => _context = context;

        public void Ask()
        {
            Interlocked.Increment(ref _asked);
            _context!.Signal();
        }

        public ReaderStep Read(out bool value)
        {
            bool isAsked = Interlocked.Exchange(ref _asked, 0) != 0;
            value = _context!.IsStopRequested;   // after the question, or it could be the answer to one asked later
            return isAsked ? ReaderStep.Value : ReaderStep.WaitForSignal;
        }

        public void Unblock()
        {
        }

        public void Close()
        {
        }
    }
}

public sealed class StopDelayInRealTime() : StopDelayContract(TimeKind.Real);

public sealed class StopDelayInVirtualTime() : StopDelayContract(TimeKind.Virtual);
