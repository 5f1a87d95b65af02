namespace Rabit.Core.WakeUp;

/// <content>
/// A sleeper that lends itself: another thread does its work while it sleeps, so that a value that comes in costs no
/// wake-up of a second thread.
/// </content>
/// <remarks>
/// Requirements, beside those of the wake-up:
/// <list type="bullet">
/// <item>the sleeper and the borrower are never at work at the same time, and each sees what the other did;</item>
/// <item>a wake or a stop that comes during the loan is not lost: the borrower signals the sleeper at its end;</item>
/// <item>a sleeper whose time is over during the loan waits for its end.</item>
/// </list>
/// A loan begins by a compare-and-swap from "asleep and lendable, nothing to consume" to "lent", which takes the mark
/// "asleep" away, so wakers only set their causes. The race it closes: the sleeper returns from its wait for whatever
/// reason, and is about to look at what there is, while a borrower comes. Before it looks it takes its marks back
/// (<see cref="TakeBack"/>), in one compare-and-swap with the look whether it is lent: either the borrower finds no
/// mark, or the sleeper finds the loan, says that it waits, and is signalled at its end.
/// </remarks>
internal partial class WakeUpEvent<TSync>
{
    private const int LendableMark = 1024;
    private const int Lent = 2048;
    private const int OwnerWaits = 4096;   // with Lent only
    private const int Lendable = Asleep | LendableMark;

    /// <summary>
    /// Begins a loan, by any other thread: it does the sleeper's work from now on, and ends it with
    /// <see cref="EndLoan"/>.
    /// </summary>
    /// <returns>False where the sleeper is awake, lends nothing, or has something to do.</returns>
    public bool TryBorrow() => default(TSync).CompareExchange(ref _state, Lent, Lendable) == Lendable;

    /// <summary>
    /// Consumes all causes, by the borrower; with a stop, which is the sleeper's, none, and there is no work to do.
    /// </summary>
    public ConsumedWakeUps ConsumeLent()
    {
        int seen = default(TSync).VolatileRead(ref _state);
        while ((seen & Stop) == 0)
        {
            int found = default(TSync).CompareExchange(ref _state, seen & (Lent | OwnerWaits), seen);
            if (found == seen)
                return new ConsumedWakeUps((WakeUpCauses)(seen & Any), (int)((uint)seen / OneWake), stop: false);
            seen = found;
        }

        return new ConsumedWakeUps(WakeUpCauses.None, 0, stop: true);
    }

    /// <summary>
    /// Ends a loan. The sleeper sleeps on as it was, or is signalled where there is something to do for it.
    /// </summary>
    /// <param name="isToWake">Whether it is woken in any case, as by its timer.</param>
    public void EndLoan(bool isToWake)
    {
        int seen = default(TSync).VolatileRead(ref _state);
        while (true)
        {
            bool signals = isToWake || (seen & (Any | OwnerWaits)) != 0;
            int next = signals ? seen & ~(Lent | OwnerWaits) : Lendable;
            if (isToWake)
                next |= (int)WakeUpCauses.Timer;
            int found = default(TSync).CompareExchange(ref _state, next, seen);
            if (found == seen)
            {
                if (signals)
                    _signal!.Set();
                return;
            }

            seen = found;
        }
    }

    /// <summary>
    /// After a wait that it could be lent in: takes the marks away, so that no loan can begin. By the sleeper.
    /// </summary>
    /// <returns>False while it is lent: wait for the signal and try again.</returns>
    public bool TakeBack()
    {
        int seen = default(TSync).VolatileRead(ref _state);
        while (true)
        {
            bool isLent = (seen & Lent) != 0;
            int found = default(TSync).CompareExchange(
                ref _state, isLent ? seen | OwnerWaits : seen & ~Lendable, seen);
            if (found == seen)
                return !isLent;
            seen = found;
        }
    }
}
