using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Predecessors;

/// <summary>
/// What queues, pools and workspaces of the predecessors got wrong; the numbers are those of
/// docs/concepts/predecessors.md.
/// </summary>
public abstract class QueueDefectsContract(TimeKind kind) : ContractTests(kind)
{
    // There: names, managers and queues stood in one place for the whole process, and the second system found those of
    // the first.
    [Fact, Trait("Defect", "16")]
    public void Workspace_OfASecondRunInOneProcess_KnowsNothingOfTheFirst()
    {
        using (TestRun first = NewRun())
        {
            first.Add("m").Publish<int>("number");
            first.StartAndSettle();
        }

        using TestRun second = NewRun();
        second.Add("m").Subscribe<int>("number");

        Assert.Contains(
            "'number'", Assert.Throws<RabitWiringException>(second.Start).Message, StringComparison.Ordinal);
    }

    // There: a second queue of the same name took the place of the first without a word, one of another type crashed.
    [Fact, Trait("Defect", "17")]
    public void Start_TwoQueuesOfOneName_AreRefusedByName()
    {
        using TestRun run = NewRun();
        run.Add("a").Receive<int>("orders");
        run.Add("b").Receive<int>("orders");
        run.Add("c").Send<string>("orders");

        string text = Assert.Throws<RabitWiringException>(run.Start).Message;

        Assert.All(["'orders'", "'a'", "'b'", "'c'"], part => Assert.Contains(part, text, StringComparison.Ordinal));
    }

    // There: a push into a full queue woke the receiver for a value that had been thrown away, uncounted.
    [Fact, Trait("Defect", "22")]
    public void Push_IntoAFullQueue_SaysSoCountsItAndWakesNoManager()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        ScriptedManager source = run.Add("source");
        QueueReceiver<int> receiver = sink.Receive<int>("orders", capacity: 1);
        QueueSender<int> sender = source.Send<int>("orders");

        run.StartAndSettle();
        run.OnAndSettle(source, () => Assert.Equal(PushResult.Queued, sender.Push(1)));
        run.Until(() => run.StatusOf(sink).Runs == 2, "the push has woken the sink");
        run.OnAndSettle(source, () => Assert.Equal(PushResult.Rejected, sender.Push(2)));
        run.OnAndSettle(sink, () => Assert.Equal(1, receiver.Counters.Rejected));

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Push, WakeUpCauses.Request], sink.Causes);
    }

    // There: a queue made for one sender could be had by many, and a value that was popped stayed in the ring and in
    // memory.
    [Fact, Trait("Defect", "23")]
    public void Pop_AValue_LetsGoOfIt()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        ScriptedManager[] sources = [run.Add("a"), run.Add("b")];
        QueueReceiver<object> receiver = sink.Receive<object>("things", capacity: 8);
        QueueSender<object>[] senders = sources.Select(s => s.Send<object>("things")).ToArray();
        var things = new List<WeakReference>();

        run.StartAndSettle();
        for (int s = 0; s < sources.Length; s++)
        {
            QueueSender<object> sender = senders[s];
            run.OnAndSettle(sources[s], () => things.Add(PushNew(sender)));
        }

        run.OnAndSettle(sink, () => Assert.Equal(2, PopAll(receiver)));

        // Mono's collector looks at stacks conservatively: it may keep one thing alive, but not what no thread has held
        // for long.
        run.OnAndSettle(sink, () => { });
        Collect();
        Assert.True(things.Count(t => t.IsAlive) <= (Type.GetType("Mono.Runtime") is null ? 0 : 1));
    }

    // There: the pool was used by several threads without a guard, and what was given back twice was lent twice.
    [Fact, Trait("Defect", "24")]
    public void Buffer_GivenBackTwice_IsLentOnce()
    {
        var pool = new BufferPool("pictures", count: 1, bufferBytes: 16);
        Assert.True(pool.TryRent("a", out BufferLease lease));
        lease.Dispose();
        lease.Dispose();

        Assert.True(pool.TryRent("b", out _));
        Assert.False(pool.TryRent("c", out _));
    }

    // There (in C#): "is there one?" and "give it to me" were two steps, and the value could be gone between them.
    [Fact, Trait("Defect", "C#")]
    public void TryPop_EmptyQueue_IsAnAnswerAndNoError()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<string?> receiver = sink.Receive<string?>("texts");
        QueueSender<string?> sender = run.Add("source").Send<string?>("texts");

        run.StartAndSettle();
        run.On(sink, () => Assert.False(receiver.TryPop(out _)));
        Assert.Equal("texts", sender.Name);
    }

    // There (in C#): a null in the queue suppressed the event of the pop, and who waited for room waited on.
    [Fact, Trait("Defect", "C#")]
    public void Pop_OfANull_WakesTheSender()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        ScriptedManager source = run.Add("source");
        QueueReceiver<string?> receiver = sink.Receive<string?>("texts", wakeOnPush: false);
        QueueSender<string?> sender = source.Send<string?>("texts", wakeOnPop: true);

        run.StartAndSettle();
        run.OnAndSettle(source, () => sender.Push(null));
        run.OnAndSettle(sink, () => Assert.True(receiver.TryPop(out _)));
        run.Until(() => source.Causes.Contains(WakeUpCauses.Pop), "the pop wakes the source");
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference PushNew(QueueSender<object> sender)
    {
        var thing = new object();
        sender.Push(thing);
        return new WeakReference(thing);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int PopAll(QueueReceiver<object> receiver)
    {
        int count = 0;
        while (receiver.TryPop(out _))
            count++;
        return count;
    }

    private static void Collect()
    {
        for (int i = 0; i < 3; i++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }
}

public sealed class QueueDefectsInRealTime() : QueueDefectsContract(TimeKind.Real);

public sealed class QueueDefectsInVirtualTime() : QueueDefectsContract(TimeKind.Virtual);
