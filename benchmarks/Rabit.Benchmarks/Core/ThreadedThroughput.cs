using System.Threading;

namespace Rabit.Benchmarks.Core;

/// <summary>Threads for the queues that have none: they wait at a barrier, send or receive their share, and meet there again.</summary>
internal abstract class ThreadedThroughput : ThroughputRun
{
    private readonly Barrier _barrier;
    private readonly int _senders;
    private volatile int _messages;
    private volatile bool _stopped;

    protected ThreadedThroughput(int senders)
    {
        _senders = senders;
        _barrier = new Barrier(senders + 2);
        for (int i = 0; i < senders; i++)
            Start(() => Send(_messages / _senders));
        Start(() => Receive(_messages));
    }

    public override void Transfer(int messages)
    {
        _messages = messages;
        _barrier.SignalAndWait();
        _barrier.SignalAndWait();
    }

    public override void Dispose()
    {
        _stopped = true;
        _barrier.RemoveParticipant();
    }

    protected abstract void Send(int count);

    protected abstract void Receive(int count);

    private void Start(System.Action work)
    {
        void Run()
        {
            while (true)
            {
                _barrier.SignalAndWait();
                if (_stopped)
                    return;
                work();
                _barrier.SignalAndWait();
            }
        }

        new Thread(Run) { IsBackground = true }.Start();
    }
}
