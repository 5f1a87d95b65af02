namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small mark of stages, into which a fault can be put. Only for the explorer to find: nothing else uses it.
/// </summary>
internal sealed class FaultyStageMark(SeededStageFault fault) : StageMarkUnderTest
{
    private const int Hanging = 1;
    private const int Kind = 2;
    private const int OneStage = 4;

    private int _word;
    private int _since;
    private int _number;

    private static ExploredSyncPoints Sync => default;

    public override void Enter(int time)
    {
        int number = fault == SeededStageFault.NoNumber ? OneStage : Sync.Read(ref _number) + OneStage;
        Sync.Write(ref _number, number);
        if (fault != SeededStageFault.TimeAfterTheStage)
            Sync.VolatileWrite(ref _since, time);
        Sync.VolatileWrite(ref _word, number | ((time & 1) * Kind));
        if (fault == SeededStageFault.TimeAfterTheStage)
            Sync.VolatileWrite(ref _since, time);
    }

    public override bool Leave()
    {
        if (fault != SeededStageFault.LeaveWithoutAnExchange)
            return (Sync.Exchange(ref _word, 0) & Hanging) != 0;
        bool wasFound = (Sync.VolatileRead(ref _word) & Hanging) != 0;
        Sync.VolatileWrite(ref _word, 0);
        return wasFound;
    }

    public override bool TryRead(out int seen, out int kind, out int since)
    {
        seen = Sync.VolatileRead(ref _word);
        kind = (seen & Kind) / Kind;
        since = Sync.VolatileRead(ref _since);
        return seen != 0 && (seen & Hanging) == 0
            && (fault == SeededStageFault.OneLook || Sync.VolatileRead(ref _word) == seen);
    }

    public override bool TryMarkHanging(int seen)
    {
        if (fault != SeededStageFault.MarkWithoutASwap)
            return Sync.CompareExchange(ref _word, seen | Hanging, seen) == seen;
        if (Sync.VolatileRead(ref _word) != seen)
            return false;
        Sync.VolatileWrite(ref _word, seen | Hanging);
        return true;
    }
}
