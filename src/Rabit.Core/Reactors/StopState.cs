using Rabit.Core.WakeUp;

namespace Rabit.Core.Reactors;

/// <summary>
/// Whether a stop was requested, whether the run stops, and how many managers delay it. Any thread.
/// </summary>
/// <remarks>
/// Requirements (contract 1.9):
/// <list type="bullet">
/// <item>a manager that counts, and after that finds no request, is waited for: no request that may wait stops the run
/// before the manager has stopped counting;</item>
/// <item>a request that finds no manager counting stops the run itself, and a later count has no effect;</item>
/// <item>of all calls exactly one is answered that the run stops, and no delay is left behind without a manager that
/// counts.</item>
/// </list>
/// All of the state is one 32-bit word, changed by compare-and-swap only, as that of <see cref="WakeUpEvent{TSync}"/>:
/// with a flag for the request and another one for the delay, a manager and a request that come together could each
/// miss the other. The tests explore every interleaving of this very code (docs/concepts/proof.md).
/// </remarks>
internal class StopState<TSync>
    where TSync : struct, ISyncPoints
{
    private const int Open = 1;        // the start-up barrier is open: a stop may wait
    private const int Requested = 2;
    private const int Delayed = 4;     // a request found managers that delay it; stays set
    private const int Stopping = 8;    // final: nothing changes any more
    private const int OneManager = 16;

    private int _state;   // written by all, by compare-and-swap

    /// <summary>Whether a stop was requested, be it delayed or not.</summary>
    public bool IsRequested => (State & Requested) != 0;

    /// <summary>Whether the run stops.</summary>
    public bool IsStopping => (State & Stopping) != 0;

    /// <summary>Whether a requested stop waits.</summary>
    public bool IsDelayed => (State & (Delayed | Stopping)) == Delayed;

    /// <summary>Whether the stop waited and then did not wait for all managers any longer.</summary>
    public bool IsCutShort
        => State is var state && (state & (Delayed | Stopping)) == (Delayed | Stopping) && state >= OneManager;

    private int State => default(TSync).VolatileRead(ref _state);

    /// <summary>From now on a stop waits for managers that delay it.</summary>
    /// <returns>False when the run stops already.</returns>
    public bool TryOpen()
    {
        int seen = State;
        while ((seen & Stopping) == 0)
        {
            if (TryChange(ref seen, seen | Open))
                return true;
        }

        return false;
    }

    public StopStep Request(StopUrgency urgency)
    {
        int seen = State;
        while (true)
        {
            bool isFirst = (seen & Requested) == 0;
            bool waits = isFirst
                ? urgency != StopUrgency.AtOnce && (seen & Open) != 0 && seen >= OneManager
                : urgency == StopUrgency.Waits;
            if ((seen & Stopping) != 0 || (waits && !isFirst))
                return StopStep.None;
            if (TryChange(ref seen, seen | Requested | (waits ? Delayed : Stopping)))
                return waits ? StopStep.Delayed : StopStep.Stops;
        }
    }

    /// <summary>One more manager delays.</summary>
    /// <returns>False when the run stops: nothing has changed.</returns>
    public bool TryAdd()
    {
        int seen = State;
        while ((seen & Stopping) == 0)
        {
            if (TryChange(ref seen, seen + OneManager))
                return true;
        }

        return false;
    }

    /// <summary>One manager delays no more.</summary>
    /// <param name="step">Whether the run stops by that.</param>
    /// <returns>False when the run stops: nothing has changed.</returns>
    public bool TryRemove(out StopStep step)
    {
        step = StopStep.None;
        int seen = State;
        while ((seen & Stopping) == 0)
        {
            int next = seen - OneManager;
            bool isLast = next < OneManager && (seen & Requested) != 0;
            if (!TryChange(ref seen, isLast ? next | Stopping : next))
                continue;
            step = isLast ? StopStep.Stops : StopStep.None;
            return true;
        }

        return false;
    }

    /// <summary>The time of a delay is over.</summary>
    public StopStep EndDelay()
    {
        int seen = State;
        while ((seen & (Delayed | Stopping)) == Delayed)
        {
            if (TryChange(ref seen, seen | Stopping))
                return StopStep.Stops;
        }

        return StopStep.None;
    }

    private bool TryChange(ref int seen, int next)
    {
        int found = default(TSync).CompareExchange(ref _state, next, seen);
        if (found == seen)
            return true;
        seen = found;
        return false;
    }
}

/// <inheritdoc/>
internal sealed class StopState : StopState<SyncPoints>;
