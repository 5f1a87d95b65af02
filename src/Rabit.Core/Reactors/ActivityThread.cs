using System;
using System.Threading;
using Rabit.Core.Managers;
using Rabit.Core.RealTimeKit;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Reactors;

/// <summary>The thread of one activity: begin, sleep until the barrier opens, steps, end.</summary>
internal sealed class ActivityThread : IDisposable
{
    private readonly Activity _activity;
    private readonly RunClock _clock;
    private readonly IWaitSignal _signal;
    private readonly RealTimeSetup _realTime;
    private readonly SharedCpus _cpus;
    private readonly object _changed;   // the engine's; pulsed when one of the two marks below is set
    private readonly Action<Exception> _fail;
    private readonly ThreadExits _exits;
    private bool _hasBegun;             // written once by the thread, read by the reactor's
    private bool _hasEnded;             // same

    public ActivityThread(
        Activity activity, EngineContext context, IWaitSignal signal, RealTimeSetup realTime, SharedCpus cpus,
        object changed, ThreadExits exits)
    {
        _activity = activity;
        _clock = context.Clock;
        _fail = context.Fail;
        _signal = signal;
        _realTime = realTime;
        _cpus = cpus;
        _changed = changed;
        _exits = exits;
        _activity.WakeUp.Connect(_signal, _clock);
    }

    /// <summary>Once true it stays so. Any thread; who sleeps until then looks under the engine's lock.</summary>
    public bool HasBegun => Volatile.Read(ref _hasBegun);

    /// <summary>As <see cref="HasBegun"/>.</summary>
    public bool HasEnded => Volatile.Read(ref _hasEnded);

    // A background thread: a manager that hangs is reported, and does not keep the process alive.
    public void Start() => new Thread(Run) { IsBackground = true }.Start();

    public void Dispose()
    {
        // A thread that did not end still needs its signal.
        if (HasEnded)
            _signal.Dispose();
    }

    private void Run()
    {
        try
        {
            // To its own thread a name is one call; to another's it is three on a file, while the reactor waits.
            Thread.CurrentThread.Name = _activity.Name;
            Live();
        }
        catch (Exception e)
        {
            LastResort.End(_activity, e, _fail);
        }

        Announce(ref _hasEnded);
        _exits.Wait();
    }

    private void Live()
    {
        _realTime.Apply(_activity);
        _activity.Begin();
        SpinPermit permit = _cpus.Enter();
        Announce(ref _hasBegun);

        new StepLoop<SyncPoints>(_activity.WakeUp, _signal, _clock, permit).Run(NextStep.AtStart(), _activity.RunStep);

        _activity.End();
    }

    private void Announce(ref bool mark)
    {
        Volatile.Write(ref mark, true);
        LastResort.DespiteInterrupts(() =>
        {
            lock (_changed)
                Monitor.PulseAll(_changed);
        });
    }
}
