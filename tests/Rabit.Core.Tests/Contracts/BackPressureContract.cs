using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 3.1 and 3.2: a sender that is held back by a full queue.</summary>
public abstract class BackPressureContract(TimeKind kind) : ContractTests(kind)
{
    private const int Values = 500;

    [Fact, Trait("Clause", "3.1"), Trait("Clause", "3.2")]
    public void Pipeline_OfHeldValues_LosesNothingAndNeedsNoTimer()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        ScriptedManager sink = run.Add("sink");
        QueueSender<int> sender = source.Send<int>("values", wakeOnPop: true);
        QueueReceiver<int> receiver = sink.Receive<int>("values", capacity: 3);
        var got = new List<int>();
        int next = 0;
        source.OnUnit = () =>
        {
            if (!sender.TryPushHeld())
                return;
            while (next < Values && sender.TryPushOrHold(next++))
            {
                // Until it is full.
            }
        };
        sink.OnUnit = () =>
        {
            if (receiver.TryPop(out int value))
                got.Add(value);
            if (receiver.Count > 0)
                sink.WakeUp();
        };

        run.Start();
        run.Until(() => sink.Units > 0 && got.Count == Values, "all values arrive");
        ReactorResult result = run.Finish();

        Assert.Equal(Enumerable.Range(0, Values), got);
        QueueResult queue = result.Queues.Single(q => q.Name == "values");
        Assert.Equal((Values, 0), (queue.Counters.Pushed, queue.Held));
    }

    [Fact, Trait("Clause", "3.5")]
    public void HeldValue_AtTheEndOfTheRun_IsReportedAndDisposed()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        run.Add("sink").Receive<Owned>("values", capacity: 1, wakeOnPush: false);
        QueueSender<Owned> sender = source.Send<Owned>("values", wakeOnPop: true);
        Owned first = new();
        Owned second = new();

        run.StartAndSettle();
        run.On(source, () =>
        {
            Assert.True(sender.TryPushOrHold(first));
            Assert.False(sender.TryPushOrHold(second));
            Assert.True(sender.IsHolding);
            Assert.False(sender.TryPushHeld());
            Assert.Contains(
                "'source'", Assert.Throws<InvalidOperationException>(() => sender.TryPushOrHold(first)).Message,
                StringComparison.Ordinal);
        });
        QueueResult queue = run.Finish().Queues.Single(q => q.Name == "values");

        Assert.Equal((1, 1), (queue.Counters.Resident, queue.Held));
        Assert.Contains("1 held", queue.ToString(), StringComparison.Ordinal);
        Assert.True(first.IsDisposed && second.IsDisposed);
    }

    [Fact, Trait("Clause", "3.2")]
    public void TryPushOrHold_NoPopWouldWakeTheSender_IsAnErrorThatSaysSo()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        source.Receive<int>("values");
        QueueSender<int> sender = source.Send<int>("values");

        run.StartAndSettle();
        string text = "";
        run.On(source, () => text = Assert.Throws<InvalidOperationException>(() => sender.TryPushOrHold(1)).Message);

        Assert.Contains("'values'", text, StringComparison.Ordinal);
        Assert.Contains("'source'", text, StringComparison.Ordinal);
        Assert.Contains("wakeOnPop: true", text, StringComparison.Ordinal);
    }

    private sealed class Owned : IDisposable
    {
        public bool IsDisposed { get; private set; }

        public void Dispose() => IsDisposed = true;
    }
}

public sealed class BackPressureInRealTime() : BackPressureContract(TimeKind.Real);

public sealed class BackPressureInVirtualTime() : BackPressureContract(TimeKind.Virtual);
