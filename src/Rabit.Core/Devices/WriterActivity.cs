using System;
using System.Threading;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Devices;

/// <summary>Writes what its manager pushes to a target.</summary>
internal sealed class WriterActivity<T>(
    string name,
    WakeUpEvent wakeUp,
    EndpointOwner manager,
    DeviceHealth health,
    ReconnectPolicy reconnect,
    IWriterTarget<T> target,
    QueueBinding<T> receiver)
    : DeviceActivity(name, wakeUp, manager, health, reconnect)
{
    private bool _unblocked;   // set by the reactor's thread, read by the writer's
    private bool _holdsValue;  // popped, and not yet written as far as the target said

    public override bool Blocks => target.Blocks;

    public override bool DrainsAtEnd => true;

    protected override bool HasWorkLeft => receiver.Queue!.Count > 0;

    /// <summary>The writer had its time to write what was left; now it is to give up.</summary>
    protected override void UnblockDevice()
    {
        Volatile.Write(ref _unblocked, true);
        target.Unblock();
    }

    protected override void OpenDevice() => target.Open();

    protected override NextStep Work()
    {
        Drain();
        return NextStep.At(TimeSpan.MaxValue);
    }

    protected override void Drain()
    {
        while (!Volatile.Read(ref _unblocked) && receiver.Queue!.TryPop(out T? value))
        {
            _holdsValue = true;
            target.Write(value);
            _holdsValue = false;
            OnProgress();
        }
    }

    protected override void CloseDevice() => target.Close();

    protected override void GiveUpValue()
    {
        if (_holdsValue)
            Health.AddDiscarded(1);
        _holdsValue = false;
    }

    // What stays in the queue is disposed with it, if it must be.
    protected override long GiveUpRest() => receiver.Queue!.Count + (_holdsValue ? 1 : 0);
}
