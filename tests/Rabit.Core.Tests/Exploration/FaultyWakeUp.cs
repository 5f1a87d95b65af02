using System;
using System.Threading;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small wake-up with causes, a count and a mark "asleep" in one word, as the real one has, into which a fault can be
/// put. Only for the explorer to find: nothing else uses it.
/// </summary>
internal sealed class FaultyWakeUp(SeededFault fault, RunClock clock) : WakeUpUnderTest
{
    private const int Stop = WakeUpEvent.Stop;
    private const int Any = WakeUpEvent.Any;
    private const int Asleep = 512;
    private const int OneWake = 1024;

    private readonly AutoResetEvent _event = new(initialState: false);
    private int _state;
    private int _isOpen;

    private static ExploredSyncPoints Sync => default;

    public override void RequestStop()
    {
        if ((Add(Stop, 0) & Asleep) != 0 && fault != SeededFault.StopWithoutASignal)
            Sync.Set(_event);
    }

    public override void Wake(WakeUpCauses cause)
    {
        if (fault == SeededFault.WakeDroppedDuringStartup && cause != WakeUpCauses.Start
            && Sync.VolatileRead(ref _isOpen) == 0)
            return;
        if (fault == SeededFault.UnfencedAlreadySetRead && (Sync.VolatileRead(ref _state) & (int)cause) != 0)
            return;
        if (fault == SeededFault.FlagSetAfterTheSignal)
        {
            if ((Sync.VolatileRead(ref _state) & Asleep) != 0)
                Sync.Set(_event);
            Add((int)cause, OneWake);
            return;
        }

        if ((Add((int)cause, OneWake) & Asleep) != 0)
            Sync.Set(_event);
    }

    public override void Run(NextStep next, Func<ConsumedWakeUps, TimeSpan?, NextStep> runStep)
    {
        while (true)
        {
            if (fault == SeededFault.FlagClearedAfterTheWork && next.Wanted == Any)
                Sync.Exchange(ref _state, 0);
            while (TryPrepareToWait(next.Wanted))
            {
                TimeSpan left = next.Due - clock.Now;
                if (left <= TimeSpan.Zero)
                {
                    Add((int)WakeUpCauses.Timer, 0);
                    break;
                }

                Sync.Wait(_event, (int)Math.Min(left.TotalMilliseconds, 3_600_000));
            }

            int taken = Take();
            if ((taken & Stop) != 0)
                return;
            if (fault == SeededFault.WakeDroppedDuringStartup && (taken & (int)WakeUpCauses.Start) != 0)
                Sync.VolatileWrite(ref _isOpen, 1);
            next = runStep(
                new ConsumedWakeUps((WakeUpCauses)(taken & Any & ~Stop), taken / OneWake, stop: false), null);
        }
    }

    // Returns what was there before.
    private int Add(int cause, int count)
    {
        int seen = Sync.VolatileRead(ref _state);
        while (true)
        {
            int found = Sync.CompareExchange(ref _state, (seen | cause) + count, seen);
            if (found == seen)
                return found;
            seen = found;
        }
    }

    private bool TryPrepareToWait(int wanted)
    {
        int seen = Sync.VolatileRead(ref _state);
        while ((seen & wanted) == 0 || fault == SeededFault.WaitWithoutRecheck)
        {
            int found = Sync.CompareExchange(ref _state, seen | Asleep, seen);
            if (found == seen)
                return true;
            seen = found;
        }

        return false;
    }

    private int Take()
    {
        int seen;
        switch (fault)
        {
            case SeededFault.FlagClearedAfterTheWork:
                return Sync.VolatileRead(ref _state);
            case SeededFault.FlagClearedByAPlainWrite:
                seen = Sync.VolatileRead(ref _state);
                Sync.Write(ref _state, 0);
                return seen;
            case SeededFault.WakesThatStack:
                seen = Sync.VolatileRead(ref _state);
                return Sync.CompareExchange(ref _state, seen / OneWake > 1 ? seen - OneWake : 0, seen) == seen
                    && seen / OneWake > 1
                    ? (seen & Any) + OneWake
                    : seen;
            default:
                return Sync.Exchange(ref _state, 0);
        }
    }
}
