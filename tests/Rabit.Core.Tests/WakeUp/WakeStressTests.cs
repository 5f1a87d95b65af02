using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

/// <summary>
/// Contract 1.4 under load: none is lost. Every step waits for the manager's answer, so a lost wake stands still.
/// </summary>
[Trait("Category", "Stress")]
public sealed class WakeStressTests
{
    private const int Rounds = 3000;

    [Fact, Trait("Clause", "1.4")]
    public void WakesPostsAndPushes_FromManyThreads_AreEachSeenByALaterUnit()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        QueueReceiver<int> receiver = manager.Receive<int>("queue");
        MessageSubscriber<int> subscriber = manager.Subscribe<int>("message", wakeOnPost: true);
        QueueSender<int> sender = run.Reactor.Workspace.Send<int>("queue");
        MessagePublisher<int> publisher = run.Reactor.Workspace.Publish<int>("message");
        int requested = 0;
        var popped = new Answer();
        var fetched = new Answer();
        var answered = new Answer();
        manager.OnUnit = () =>
        {
            while (receiver.TryPop(out int value))
                popped.Give(value);
            if (subscriber.Fetch())
                fetched.Give(subscriber.Value);
            answered.Give(Volatile.Read(ref requested));
        };

        run.StartAndSettle();
        var failures = new List<string>();
        Thread[] threads =
        [
            Drive("push", popped, i => sender.Push(i), failures),
            Drive("post", fetched, i =>
            {
                publisher.Value = i;
                publisher.Post();
            }, failures),
            Drive("wake", answered, i =>
            {
                Volatile.Write(ref requested, i);
                manager.WakeUp();
            }, failures),
        ];
        foreach (Thread thread in threads)
            thread.Join();

        Assert.Empty(failures);
        Assert.Equal(0, run.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "1.4"), Trait("Clause", "1.8")]
    public void TwoManagers_ThatAnswerEachOther_NeverStandStill()
    {
        const int RoundTrips = 20_000;
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager left = run.Add("left");
        ScriptedManager right = run.Add("right");
        QueueSender<int> toRight = left.Send<int>("to right");
        QueueReceiver<int> fromLeft = right.Receive<int>("to right");
        QueueSender<int> toLeft = right.Send<int>("to left");
        QueueReceiver<int> fromRight = left.Receive<int>("to left");
        int last = 0;
        left.OnUnit = () =>
        {
            while (fromRight.TryPop(out int value))
            {
                Volatile.Write(ref last, value);
                if (value < RoundTrips)
                    toRight.Push(value + 1);
            }
        };
        right.OnUnit = () =>
        {
            while (fromLeft.TryPop(out int value))
                toLeft.Push(value + 1);
        };

        run.StartAndSettle();
        run.On(left, () => toRight.Push(1));
        run.Until(() => Volatile.Read(ref last) >= RoundTrips, "the ball goes to and fro to the end");
        Assert.Equal(0, run.Finish().ExitCode);
    }

    private static Thread Drive(string what, Answer answer, Action<int> act, List<string> failures)
    {
        var thread = new Thread(() =>
        {
            for (int i = 1; i <= Rounds; i++)
            {
                act(i);
                if (answer.TryAwait(i))
                    continue;
                lock (failures)
                    failures.Add($"{what} {i} was lost");
                return;
            }
        });
        thread.Start();
        return thread;
    }

    /// <summary>The highest number that the manager has seen.</summary>
    private sealed class Answer
    {
        private int _seen;   // under this object's lock, given by the manager, awaited by a driver

        public void Give(int value)
        {
            lock (this)
            {
                _seen = Math.Max(_seen, value);
                Monitor.PulseAll(this);
            }
        }

        public bool TryAwait(int value)
        {
            lock (this)
            {
                while (_seen < value)
                {
                    if (!Monitor.Wait(this, TestTimeout.Limit))
                        return false;
                }
            }

            return true;
        }
    }
}
