using System;
using System.Threading;
using Rabit.Core.Diagnostics;

namespace Rabit.Core.Managers;

/// <summary>What readers and writers have in common: they open a device at their first turn, and report what it throws.</summary>
internal abstract class DeviceActivity(string name, WakeUpEvent wakeUp, EndOwner manager, DeviceHealth health) : Activity(name, wakeUp)
{
    private bool _isOpen;
    private bool _hasBegun;   // written by the device's thread, read by the reactor's

    public abstract bool Blocks { get; }

    public override string Doing => "using its device";

    /// <summary>Whether it has a thread or turns: not where the run was stopped before the barrier opened.</summary>
    public bool HasBegun => Volatile.Read(ref _hasBegun);

    /// <summary>Whether it must still use its device when it is stopped before its first turn.</summary>
    protected virtual bool HasWorkLeft => false;

    protected DeviceHealth Health { get; } = health;

    protected RunClock Clock { get; private set; } = null!;

    protected RabitLog? Log { get; private set; }

    protected bool HasFinished => Health.State is DeviceState.Ended or DeviceState.Faulted;

    public void Connect(RunClock clock, RabitLog log)
    {
        Clock = clock;
        Log = log;
    }

    public override void Begin() => Volatile.Write(ref _hasBegun, true);

    /// <summary>Instead of all turns, on the reactor's thread: it never began, and counts what is lost by that.</summary>
    public virtual void Abandon()
    {
    }

    public override NextTurn TakeTurn(WakeUps wakes, TimeSpan? wokenAt)
    {
        if (HasFinished)
            return NextTurn.Never;
        try
        {
            if (!_isOpen)
            {
                Health.State = DeviceState.Running;
                _isOpen = true;
                Open();
            }

            return Work();
        }
        catch (Exception e)
        {
            // A device is the outside world: whatever it throws is a fault of this reader or writer and of nobody else.
            Finish(DeviceState.Faulted, e);
            return NextTurn.Never;
        }
    }

    public override void End()
    {
        if (!_isOpen && HasWorkLeft)
            TakeTurn(default, wokenAt: null);
        try
        {
            if (_isOpen)
                Close();
        }
        catch (Exception e)
        {
            Report("could not close its device", e);
        }

        if (!HasFinished)
            Health.State = DeviceState.Stopped;
    }

    public override void Unblock()
    {
        try
        {
            UnblockDevice();
        }
        catch (Exception e)
        {
            // It runs on the thread that stops all the others: they must be stopped all the same.
            Report("could not unblock its device", e);
        }
    }

    protected abstract void UnblockDevice();

    protected abstract void Open();

    protected abstract NextTurn Work();

    protected abstract void Close();

    protected void Finish(DeviceState state, Exception? fault)
    {
        Health.Fault = fault;
        Health.State = state;
        if (fault is null)
            Log!.Write(RabitLogKind.Lifecycle, Name, "ended");
        else
            Report("failed", fault);
        manager.WakeUp!.Wake(WakeUpCauses.Device);
    }

    protected void ReportDiscarded(long count)
    {
        Health.AddDiscarded(count);
        if (count > 0)
            Log!.Write(RabitLogKind.Note, Name, FormattableString.Invariant($"{count} values were lost at the end"));
    }

    private void Report(string what, Exception e)
        => Log!.Write(RabitLogKind.Fault, Name, $"{what}: {e.GetType().Name}: {e.Message}", e);
}
