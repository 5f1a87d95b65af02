using System;
using System.Threading;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small sleeper that lends itself, with everything in one word, as the real one has it, into which a fault can be
/// put. Only for the explorer to find: nothing else uses it.
/// </summary>
internal sealed class FaultyLoan(SeededLoanFault fault, RunClock clock) : LoanUnderTest
{
    private const int Stop = WakeUpEvent.Stop;
    private const int Any = WakeUpEvent.Any;
    private const int Asleep = 512;
    private const int Lendable = 512 | 1024;
    private const int Lent = 2048;
    private const int OwnerWaits = 4096;
    private const int OneWake = 8192;

    private readonly AutoResetEvent _event = new(initialState: false);
    private int _state;

    private static ExploredSyncPoints Sync => default;

    public override void RequestStop()
    {
        if ((Change(seen => seen | Stop) & Asleep) != 0)
            Sync.Set(_event);
    }

    public override void Wake(WakeUpCauses cause)
    {
        if ((Change(seen => (seen | (int)cause) + OneWake) & Asleep) != 0)
            Sync.Set(_event);
    }

    public override bool TryBorrow()
    {
        if (fault != SeededLoanFault.BorrowsTheAwake)
            return Sync.CompareExchange(ref _state, Lent, Lendable) == Lendable;
        int seen = Sync.VolatileRead(ref _state);
        return (seen & Lent) == 0 && Sync.CompareExchange(ref _state, (seen & ~Lendable) | Lent, seen) == seen;
    }

    public override ConsumedWakeUps ConsumeLent()
    {
        bool stops = false;
        int seen = Change(s =>
        {
            stops = (s & Stop) != 0 && fault != SeededLoanFault.BorrowerIgnoresTheStop;
            return stops ? s : s & (Lent | OwnerWaits | Stop);
        });
        return stops ? new ConsumedWakeUps(WakeUpCauses.None, 0, stop: true) : Consumed(seen);
    }

    public override void EndLoan(bool isToWake)
    {
        int seen = Change(s =>
        {
            if (fault == SeededLoanFault.LoanEndsWithoutALook)
                return Lendable;
            return (s & (Any | OwnerWaits)) != 0 || isToWake ? s & ~(Lent | OwnerWaits) : Lendable;
        });
        if (((seen & (Any | OwnerWaits)) != 0 || isToWake) && fault != SeededLoanFault.LoanEndsWithoutASignal)
            Sync.Set(_event);
    }

    public override void Run(NextStep next, Func<ConsumedWakeUps, TimeSpan?, NextStep> runStep)
    {
        while (true)
        {
            while (TryPrepareToWait(next))
            {
                TimeSpan left = next.Due - clock.Now;
                if (left > TimeSpan.Zero)
                    WaitFor(left);
                while (next.Lends && !TakeBack())
                    WaitFor(TimeSpan.FromHours(1));
                if ((Sync.VolatileRead(ref _state) & next.Wanted) == 0 && clock.Now >= next.Due)
                {
                    Change(seen => seen | (int)WakeUpCauses.Timer);
                    break;
                }
            }

            int taken = Sync.Exchange(ref _state, 0);
            if ((taken & Stop) != 0)
                return;
            next = runStep(Consumed(taken), null);
        }
    }

    private static ConsumedWakeUps Consumed(int state)
        => new((WakeUpCauses)(state & Any & ~Stop), state / OneWake, stop: false);

    private void WaitFor(TimeSpan time) => Sync.Wait(_event, (int)Math.Min(time.TotalMilliseconds, 3_600_000));

    private bool TakeBack()
    {
        switch (fault)
        {
            case SeededLoanFault.SleeperDoesNotTakeBack:
                return true;
            case SeededLoanFault.TakesBackInTwoSteps:
                if ((Sync.VolatileRead(ref _state) & Lent) != 0)
                    goto default;
                Change(seen => seen & ~Lendable);
                return true;
            case SeededLoanFault.SleeperWaitsUnnoticed:
                return (Change(seen => (seen & Lent) != 0 ? seen : seen & ~Lendable) & Lent) == 0;
            default:
                return (Change(seen => (seen & Lent) != 0 ? seen | OwnerWaits : seen & ~Lendable) & Lent) == 0;
        }
    }

    private bool TryPrepareToWait(NextStep next)
    {
        int seen = Sync.VolatileRead(ref _state);
        while ((seen & next.Wanted) == 0)
        {
            int found = Sync.CompareExchange(ref _state, seen | (next.Lends ? Lendable : Asleep), seen);
            if (found == seen)
                return true;
            seen = found;
        }

        return false;
    }

    // Returns what was there before.
    private int Change(Func<int, int> change)
    {
        int seen = Sync.VolatileRead(ref _state);
        while (true)
        {
            int found = Sync.CompareExchange(ref _state, change(seen), seen);
            if (found == seen)
                return found;
            seen = found;
        }
    }
}
