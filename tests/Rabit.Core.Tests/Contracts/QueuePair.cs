using System;

namespace Rabit.Core.Tests.Contracts;

/// <summary>One manager that sends to a queue and one that receives it.</summary>
internal sealed class QueuePair : IDisposable
{
    public QueuePair(TestRun run, int capacity, QueueFullMode whenFull, bool wakeOnPush, bool wakeOnPop)
    {
        Run = run;
        Source = run.Add("source");
        Sink = run.Add("sink");
        Sender = Source.Send<int>("queue", wakeOnPop);
        Receiver = Sink.Receive<int>("queue", capacity, whenFull, wakeOnPush);
        run.StartAndSettle();
    }

    public TestRun Run { get; }

    public ScriptedManager Source { get; }

    public ScriptedManager Sink { get; }

    public QueueSender<int> Sender { get; }

    public QueueReceiver<int> Receiver { get; }

    public void Dispose() => Run.Dispose();
}
