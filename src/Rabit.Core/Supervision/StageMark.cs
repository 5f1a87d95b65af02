using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Supervision;

/// <summary>
/// Which stage a manager is in, and since when. Written by the manager's thread with every stage, read by the watchdog
/// and by the reports of what the manager is doing.
/// </summary>
/// <remarks>
/// The word holds the stage, a mark "found hanging", and a number that is new with every stage, so that the watchdog,
/// which looks and then marks, cannot mark a later stage than it looked at: the mark is a compare-and-swap. The manager
/// leaves with an exchange, so either the mark comes first and the manager sees it, or the watchdog's mark fails.
/// The tests explore every interleaving of this very code (docs/concepts/proof.md).
/// </remarks>
internal sealed class StageMark<TSync>
    where TSync : struct, ISyncPoints
{
    private const int StageBits = 3;
    private const int Hanging = 4;
    private const int OneStage = 8;

    private int _word;         // see the remarks; 0: in no stage
    private long _sinceTicks;  // written before the word that it belongs to
    private int _number;       // the manager's thread only

    /// <summary>The stage; null for none. Any thread.</summary>
    public ManagerStage? Stage => StageOf(default(TSync).VolatileRead(ref _word));

    public void Enter(ManagerStage stage, TimeSpan now)
    {
        default(TSync).VolatileWrite(ref _sinceTicks, now.Ticks);
        int number = unchecked(default(TSync).Read(ref _number) + OneStage);
        default(TSync).Write(ref _number, number);
        default(TSync).VolatileWrite(ref _word, number | ((int)stage + 1));
    }

    /// <returns>Whether the watchdog found it hanging in this stage.</returns>
    public bool Leave() => (default(TSync).Exchange(ref _word, 0) & Hanging) != 0;

    /// <summary>Looks once. False when the manager is in no stage, was found already, or is just moving.</summary>
    public bool TryRead(out int seen, out ManagerStage stage, out TimeSpan since)
    {
        seen = default(TSync).VolatileRead(ref _word);
        stage = StageOf(seen) ?? default;
        since = new TimeSpan(default(TSync).VolatileRead(ref _sinceTicks));
        return seen != 0 && (seen & Hanging) == 0 && default(TSync).VolatileRead(ref _word) == seen;
    }

    /// <summary>Marks what was seen as hanging.</summary>
    /// <returns>False when the manager has left that stage.</returns>
    public bool TryMarkHanging(int seen)
        => default(TSync).CompareExchange(ref _word, seen | Hanging, seen) == seen;

    private static ManagerStage? StageOf(int word)
        => (word & StageBits) == 0 ? null : (ManagerStage)((word & StageBits) - 1);
}
