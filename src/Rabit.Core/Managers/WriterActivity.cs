using System;
using System.Threading;
using Rabit.Core.Messaging;

namespace Rabit.Core.Managers;

/// <summary>Writes what its manager pushes to a target.</summary>
internal sealed class WriterActivity<T>(
    string name, WakeUpEvent wakeUp, EndOwner manager, DeviceHealth health, IWriterTarget<T> target, QueueBinding<T> receiver)
    : DeviceActivity(name, wakeUp, manager, health)
{
    private bool _unblocked;   // set by the reactor's thread, read by the writer's
    private bool _holdsValue;  // popped, and not yet written as far as the target said

    public override bool Blocks => target.Blocks;

    public override bool DrainsAtEnd => true;

    protected override bool HasWorkLeft => receiver.Queue!.Count > 0;

    public override void Abandon() => ReportDiscarded(receiver.Queue!.Count);

    /// <summary>The writer had its time to write what was left; now it is to give up.</summary>
    protected override void UnblockDevice()
    {
        Volatile.Write(ref _unblocked, true);
        target.Unblock();
    }

    protected override void Open() => target.Open();

    protected override NextTurn Work()
    {
        while (!Volatile.Read(ref _unblocked) && receiver.Queue!.TryPop(out T? value))
        {
            _holdsValue = true;
            target.Write(value);
            _holdsValue = false;
        }

        return NextTurn.At(TimeSpan.MaxValue);
    }

    protected override void Close()
    {
        try
        {
            if (!HasFinished)
                Work();
        }
        finally
        {
            ReportDiscarded(receiver.Queue!.Count + (_holdsValue ? 1 : 0));
            target.Close();
        }
    }
}
