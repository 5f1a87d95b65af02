using System;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Supervision;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Devices;

/// <summary>
/// What readers and writers have in common: they open a device at their first step, report what it throws, and open it
/// again.
/// </summary>
internal abstract class DeviceActivity(
    string name, WakeUpEvent wakeUp, EndpointOwner manager, DeviceHealth health, ReconnectPolicy reconnect)
    : Activity(name, wakeUp)
{
    private bool _isOpen;
    private bool _wasOpened;
    private int _failures;    // in a row: without a value that was read or written
    private bool _hasBegun;   // written by the device's thread, read by the reactor's and the manager's

    public abstract bool Blocks { get; }

    public override string Doing
        => Health.State == DeviceState.Reconnecting ? "opening its device again" : "using its device";

    /// <summary>Whether it has a thread or steps: not where the run was stopped before the barrier opened.</summary>
    public bool HasBegun => Volatile.Read(ref _hasBegun);

    /// <summary>Whether it must still use its device when it is stopped before its first step.</summary>
    protected virtual bool HasWorkLeft => false;

    protected DeviceHealth Health { get; } = health;

    protected RunClock Clock { get; private set; } = null!;

    protected RabitLog? Log { get; private set; }

    /// <summary>Its manager, which may lend its units of work.</summary>
    protected ManagerActivity Lender { get; private set; } = null!;

    protected bool HasFinished => Health.State is DeviceState.Ended or DeviceState.Faulted;

    public void Connect(RunClock clock, RabitLog log, ManagerActivity lender)
    {
        Clock = clock;
        Log = log;
        Lender = lender;
    }

    public override void Begin() => Volatile.Write(ref _hasBegun, true);

    /// <summary>
    /// Instead of all steps, on the reactor's thread: it never began, and counts what is lost by that.
    /// </summary>
    public void Abandon() => ReportLost();

    /// <summary>Asks it to end with its manager, which does not wait for it. The manager's thread.</summary>
    public void StopAlone()
    {
        if (!HasBegun)
            return;
        WakeUp.RequestStop();
        if (!DrainsAtEnd)
            Unblock();
    }

    public override NextStep RunStep(ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        if (HasFinished)
            return NextStep.Never;
        try
        {
            if (!_isOpen)
                OpenAgain();
            return Work();
        }
        catch (Exception e)
        {
            // A device is the outside world: what it throws is a fault of this reader or writer alone.
            return AfterFault(e);
        }
    }

    public override void End()
    {
        if (!_wasOpened && HasWorkLeft)
            RunStep(default, wokenAt: null);
        try
        {
            if (_isOpen && !HasFinished)
                Drain();
        }
        catch (Exception e)
        {
            Health.AddFault(e);
            Report("failed", e);
        }

        ReportLost();
        Close();
        if (!HasFinished)
            Health.Enter(DeviceState.Stopped, Clock.Now);
    }

    public override bool TryEndAfter(Exception unexpected)
    {
        if (Health.State != DeviceState.Faulted)
        {
            Health.AddFault(unexpected);
            Health.Enter(DeviceState.Faulted, Clock.NowOr(Health.Since));
        }

        Report("ended unexpectedly", unexpected);
        Close();
        ReportLost();
        manager.WakeUp!.Wake(WakeUpCauses.Device, Health.Since);
        return true;
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

    protected abstract void OpenDevice();

    protected abstract NextStep Work();

    /// <summary>Does what is left to do at the end.</summary>
    protected virtual void Drain()
    {
    }

    protected abstract void CloseDevice();

    /// <summary>Gives up the value in hand after a fault, if it may have been used in part.</summary>
    protected virtual void GiveUpValue()
    {
    }

    /// <summary>Gives up what is left at the end.</summary>
    /// <returns>How many values.</returns>
    protected abstract long GiveUpRest();

    /// <summary>A value was read or written: the next fault is the first of a new row.</summary>
    protected void OnProgress() => _failures = 0;

    protected void Finish()
    {
        Health.Enter(DeviceState.Ended, Clock.Now);
        Log!.Write(RabitLogKind.Lifecycle, Name, "ended");
        manager.WakeUp!.Wake(WakeUpCauses.Device);
    }

    private void OpenAgain()
    {
        bool isReconnect = _wasOpened;
        _isOpen = _wasOpened = true;
        if (!isReconnect)
            Health.Enter(DeviceState.Running, Clock.Now);
        OpenDevice();
        if (!isReconnect)
            return;
        Health.AddReconnect();
        Health.Enter(DeviceState.Running, Clock.Now);
        Log!.Write(
            RabitLogKind.Lifecycle, Name,
            FormattableString.Invariant($"its device is open again, reconnect {Health.Reconnects}"));
        manager.WakeUp!.Wake(WakeUpCauses.Device);
    }

    private NextStep AfterFault(Exception fault)
    {
        Health.AddFault(fault);
        if (_failures >= reconnect.MaxAttempts)
        {
            Health.Enter(DeviceState.Faulted, Clock.Now);
            Report("failed", fault);
            manager.WakeUp!.Wake(WakeUpCauses.Device);
            return NextStep.Never;
        }

        GiveUpValue();
        Close();
        TimeSpan delay = BackOff.Delay(reconnect.FirstDelay, reconnect.MaxDelay, _failures);
        if (Health.State != DeviceState.Reconnecting)
            Health.Enter(DeviceState.Reconnecting, Clock.Now);

        // A device that is away for hours fails again and again: only the first failure is logged.
        if (_failures++ == 0)
            Report("failed, and will be opened again", fault);
        manager.WakeUp!.Wake(WakeUpCauses.Device);
        return NextStep.OnlyAt(Times.Later(Clock.Now, delay));
    }

    private void Close()
    {
        if (!_isOpen)
            return;
        _isOpen = false;
        try
        {
            CloseDevice();
        }
        catch (Exception e)
        {
            Report("could not close its device", e);
        }
    }

    private void ReportLost()
    {
        long count = GiveUpRest();
        Health.AddDiscarded(count);
        if (count > 0)
            Log!.Write(RabitLogKind.Note, Name, FormattableString.Invariant($"{count} values were lost at the end"));
    }

    private void Report(string what, Exception e)
        => Log!.Write(RabitLogKind.Fault, Name, $"{what}: {ExceptionText.Describe(e)}", e);
}
