using System;
using Rabit.Core.Messaging;

namespace Rabit.Core.Managers;

/// <summary>Reads a source into its manager's queue.</summary>
internal sealed class ReaderActivity<T>(
    string name,
    WakeUpEvent wakeUp,
    EndOwner manager,
    DeviceHealth health,
    ReconnectPolicy reconnect,
    IReaderSource<T> source,
    QueueBinding<T> sender)
    : DeviceActivity(name, wakeUp, manager, health, reconnect)
{
    // A source that always has more gives the others a turn, and a stop a chance, after so many values.
    private const int ValuesPerTurn = 64;

    private T _value = default!;
    private bool _holdsValue;   // read, and waiting for room in the queue

    public override bool Blocks => source.Blocks;

    protected override void UnblockDevice() => source.Unblock();

    protected override void OpenDevice() => source.Open(new ReaderContext(Clock, WakeUp));

    protected override NextTurn Work()
    {
        for (int values = 0; values < ValuesPerTurn && !WakeUp.StopRequested; values++)
        {
            if (_holdsValue && !TryHandOver())
                return NextTurn.At(TimeSpan.MaxValue);

            ReaderStep step = source.Read(out _value);
            if (step.Kind == ReaderStepKind.Wait)
                return NextTurn.At(step.Due);
            if (step.Kind == ReaderStepKind.Ended)
            {
                Finish();
                return NextTurn.Never;
            }

            _holdsValue = true;
            OnProgress();
        }

        return _holdsValue && !TryHandOver() ? NextTurn.At(TimeSpan.MaxValue) : NextTurn.At(TimeSpan.Zero);
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
        MessageQueue<T> queue = sender.Queue!;
        if (queue.FullMode == QueueFullMode.Wait)
        {
            _holdsValue = !queue.TryPushOrWait(_value, WakeUp);
        }
        else
        {
            // The books of the queue tell what was rejected or dropped.
            if (queue.Push(_value) == PushResult.Rejected)
                Discard();
            _holdsValue = false;
        }

        return !_holdsValue;
    }

    // What the queue did not take is still ours.
    private void Discard()
    {
        if (Discarded<T>.Matters)
            Discarded<T>.Dispose(_value, Name, Log);
    }
}
