using System;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Devices;

/// <summary>Reads a source into its manager's queue.</summary>
internal sealed class ReaderActivity<T>(
    string name,
    WakeUpEvent wakeUp,
    EndpointOwner manager,
    DeviceHealth health,
    ReconnectPolicy reconnect,
    IReaderSource<T> source,
    QueueBinding<T> sender)
    : DeviceActivity(name, wakeUp, manager, health, reconnect)
{
    // A source that always has more yields to the others, and to a stop, after so many values.
    private const int ValuesPerStep = 64;

    private T _value = default!;
    private bool _holdsValue;   // read, and waiting for room in the queue
    private TimeSpan? _giveUpAt;

    public override bool Blocks => source.Blocks;

    protected override void UnblockDevice() => source.Unblock();

    protected override void OpenDevice() => source.Open(new ReaderContext(Clock, WakeUp, Lender.Stop));

    protected override NextStep Work()
    {
        for (int values = 0; values < ValuesPerStep && !WakeUp.StopRequested; values++)
        {
            if (_holdsValue && !TryHandOver())
                return WaitForRoom();

            ReaderStep step = source.Read(out _value);
            if (step.Kind == ReaderStepKind.Wait)
                return NextStep.At(step.Due);
            if (step.Kind == ReaderStepKind.Ended)
            {
                Finish();
                return NextStep.Never;
            }

            _holdsValue = true;
            OnProgress();
        }

        return _holdsValue && !TryHandOver() ? WaitForRoom() : NextStep.At(TimeSpan.Zero);
    }

    protected override void CloseDevice() => source.Close();

    protected override long GiveUpRest()
    {
        if (!_holdsValue)
            return 0;
        Discard();
        return 1;
    }

    private bool TryHandOver()
    {
        MessageQueue<T, SyncPoints> queue = sender.Queue!;
        if (queue.FullMode == QueueFullMode.Wait)
            return TryHandOver((LockedQueue<T>)queue);

        // Before the push, which otherwise wakes the manager's thread.
        bool runsManager = Lender.TryBorrow();
        try
        {
            // The counters of the queue hold what was rejected or dropped.
            if (queue.Push(_value) == PushResult.Rejected)
                Discard();
            _holdsValue = false;
        }
        finally
        {
            if (runsManager)
                Lender.RunBorrowed();
        }

        return true;
    }

    private bool TryHandOver(LockedQueue<T> queue)
    {
        if (!queue.TryPushOrWait(_value, WakeUp))
        {
            TimeSpan now = Clock.Now;
            _giveUpAt ??= Times.Later(now, queue.MaxWait ?? TimeSpan.MaxValue);
            if (now < _giveUpAt)
                return false;
            queue.GiveUp();
            Discard();
        }

        _giveUpAt = null;
        _holdsValue = false;
        return true;
    }

    private NextStep WaitForRoom() => NextStep.At(_giveUpAt ?? TimeSpan.MaxValue);

    // What the queue did not take is still ours.
    private void Discard()
    {
        if (Discarded<T>.Matters)
            Discarded<T>.Dispose(_value, Name, Log);
    }
}
