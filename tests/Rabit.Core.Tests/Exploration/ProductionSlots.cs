using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>The slots of the library.</summary>
internal sealed class ProductionSlots : SlotsUnderTest
{
    private readonly SlotPool<TwoWords, ExploredSyncPoints> _pool;
    private long _latest;

    public ProductionSlots(SlotScenario scenario)
    {
        _pool = new SlotPool<TwoWords, ExploredSyncPoints>(
            new TwoWords(), () => new TwoWords(), scenario.Tries, scenario.IsAlone);
        _pool.NewSpares(scenario.Slots - 1, isOutside: false);
    }

    public override ref long Latest => ref _latest;

    public override int Store(int value, SpareSlots spares)
        => _pool.Store(new TwoWordsCopier(value), spares, ref _latest);

    public override int Load(out TwoWordsCopier fetched)
    {
        fetched = default;
        return _pool.Load(ref fetched, ref _latest);
    }
}
