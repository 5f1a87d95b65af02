using System;
using System.Runtime.CompilerServices;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>
/// Wakes one sleeper. Any thread may wake; only the sleeper prepares to wait, waits and consumes.
/// </summary>
/// <remarks>
/// Requirements (contract 1.2, 1.4, 1.6):
/// <list type="bullet">
/// <item>a wake that returned is seen by a consume that starts later: none is lost;</item>
/// <item>wakes merge: any number between two consumes are one, with all their causes, and are counted;</item>
/// <item>a wake of a sleeper that is awake costs one interlocked operation and never enters the kernel;</item>
/// <item>a stop gets through whatever the sleeper waits for.</item>
/// </list>
/// All of the state is one 32-bit word (64-bit words are not atomic on the 32-bit boards we run on): causes, a mark
/// "asleep", and the number of wakes since the last consume. It is changed by compare-and-swap only, a full fence on
/// every runtime, so what a waker wrote before it woke is visible to the sleeper after it consumed.
/// The race it closes (the lost wake-up): the sleeper checks, finds nothing, and is about to wait, while a waker sets a
/// cause. The mark and the check are one compare-and-swap: either the waker finds the mark and signals, or the sleeper
/// finds the cause and does not wait. A signal that comes late (the sleeper had already timed out) is kept by the
/// signal and ends the next wait early; the sleeper must check again, and does.
/// The tests explore every interleaving of this very code (docs/concepts/proof.md).
/// </remarks>
internal partial class WakeUpEvent<TSync>
    where TSync : struct, ISyncPoints
{
    public const int Stop = 256;

    /// <summary>All causes, and the stop.</summary>
    public const int Any = Stop | (Stop - 1);

    // These wake even a sleeper that waits for them alone and already holds other causes.
    private const int Urgent = Stop | (int)WakeUpCauses.Start;
    private const int Asleep = 512;
    private const int OneWake = 8192;
    private const uint CountIsFull = 0xFFFF_E000;

    private const long NotSet = -1;

    private int _state;            // written by all, by compare-and-swap
    // written by the waker that ends a sleep, before it signals; read and unset by the sleeper
    private long _wokenAtTicks;
    private IWakeSignal? _signal;  // written once, before the sleeper first sleeps
    private RunClock? _clock;      // same

    /// <summary>Whether a stop was requested and not yet consumed.</summary>
    public bool StopRequested => Has(Stop);

    /// <summary>
    /// When the wake that ended the last sleep came; null while the waker, who has set the cause already, has not
    /// written it.
    /// </summary>
    public TimeSpan? WokenAt
        => default(TSync).InterlockedRead(ref _wokenAtTicks) is var ticks && ticks == NotSet
            ? null
            : new TimeSpan(ticks);

    /// <summary>Sets what to signal. Wakes that came before are kept.</summary>
    public void Connect(IWakeSignal signal, RunClock clock)
    {
        _clock = clock;
        _signal = signal;
    }

    public void Wake(WakeUpCauses cause) => Wake((int)cause, now: null);

    /// <summary>As <see cref="Wake(WakeUpCauses)"/>, by a waker that has just read the clock of the run.</summary>
    public void Wake(WakeUpCauses cause, TimeSpan now) => Wake((int)cause, now);

    public void RequestStop() => Wake(Stop, now: null);

    /// <summary>Prepares to wait: marks the sleeper asleep, unless one of the wanted causes is already set.</summary>
    /// <param name="wanted">The causes.</param>
    /// <param name="lends">Whether others may do its work while it sleeps; it wants any cause then.</param>
    /// <returns>False when there is something to consume now.</returns>
    public bool TryPrepareToWait(int wanted, bool lends = false)
    {
        int mark = lends ? Lendable : Asleep;
        int seen = default(TSync).VolatileRead(ref _state);
        while ((seen & wanted) == 0)
        {
            // Before the mark: a waker writes its time after it has found the mark.
            default(TSync).InterlockedWrite(ref _wokenAtTicks, NotSet);
            int found = default(TSync).CompareExchange(ref _state, seen | mark, seen);
            if (found == seen)
                return true;
            seen = found;
        }

        return false;
    }

    /// <summary>Whether one of the wanted causes is set.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Has(int wanted) => (default(TSync).VolatileRead(ref _state) & wanted) != 0;

    /// <summary>Consumes all causes, and clears the mark "asleep".</summary>
    public ConsumedWakeUps Consume()
    {
        int consumed = default(TSync).Exchange(ref _state, 0);
        return new ConsumedWakeUps(
            (WakeUpCauses)(consumed & Any & ~Stop), (int)((uint)consumed / OneWake), (consumed & Stop) != 0);
    }

    private void Wake(int cause, TimeSpan? now)
    {
        int seen = default(TSync).VolatileRead(ref _state);
        while (true)
        {
            int next = seen | cause;
            if (cause != Stop && (uint)seen < CountIsFull)
                next += OneWake;
            int found = default(TSync).CompareExchange(ref _state, next, seen);
            if (found == seen)
                break;
            seen = found;
        }

        bool first = (seen & Any) == 0 || (cause & Urgent) != 0;
        if ((seen & Asleep) != 0 && first)
        {
            default(TSync).InterlockedWrite(ref _wokenAtTicks, (now ?? _clock!.Now).Ticks);
            _signal!.Set();
        }
    }
}

/// <inheritdoc/>
internal sealed class WakeUpEvent : WakeUpEvent<SyncPoints>;
