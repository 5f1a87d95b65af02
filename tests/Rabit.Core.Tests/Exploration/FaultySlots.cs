using System.Linq;
using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small twin of the slots of the library (<see cref="SlotPool{TSlot, TSync}"/>), right or with one fault: to show
/// that the exploration finds it.
/// </summary>
internal sealed class FaultySlots(SlotScenario scenario, SeededSlotFault fault) : SlotsUnderTest
{
    private static ExploredSyncPoints Sync => default;

    private readonly TwoWords[] _slots = [.. Enumerable.Range(0, scenario.Slots + 1).Select(_ => new TwoWords())];
    private long _latest;
    private int _demanded;

    public override ref long Latest => ref _latest;

    public override int Store(int value, SpareSlots spares)
    {
        bool isPlain = scenario is { IsAlone: true, Tries: > 0 }
            && (fault == SeededSlotFault.DemandIgnored || Sync.VolatileRead(ref _demanded) == 0);
        TwoWords slot = Take(spares);
        int version = LatestSlot.VersionOf(Sync.VolatileRead(ref _latest)) + 1;
        if (fault != SeededSlotFault.VersionAfterTheValue)
            Spoil(slot, version);
        new TwoWordsCopier(value).CopyTo(slot);
        if (fault == SeededSlotFault.VersionAfterTheValue)
            Spoil(slot, version);
        return Publish(slot, spares, isPlain || fault == SeededSlotFault.NoSwap);
    }

    public override int Load(out TwoWordsCopier fetched)
    {
        fetched = default;
        return LoadInto(ref fetched);
    }

    private TwoWords Take(SpareSlots spares)
    {
        for (int i = 0; i < spares.Count; i++, spares.Skip())
        {
            if (fault == SeededSlotFault.SpareTakenThoughPinned
                || Sync.VolatileRead(ref _slots[spares.Next].Pins) == 0)
            {
                return _slots[spares.Next];
            }
        }

        // As the pool grows, by one slot that is there from the start.
        spares.Add(scenario.Slots);
        return _slots[scenario.Slots];
    }

    private void Spoil(TwoWords slot, int version)
    {
        Sync.VolatileWrite(ref slot.Version, version);
        if (fault != SeededSlotFault.NoStoreBarrier)
            Sync.StoreBarrier();
    }

    private int Publish(TwoWords slot, SpareSlots spares, bool isPlain)
    {
        while (true)
        {
            long word = Sync.VolatileRead(ref _latest);
            int version = LatestSlot.VersionOf(word) + 1;
            if (!isPlain)
                Sync.VolatileWrite(ref slot.Version, version);
            long next = LatestSlot.Join(version, spares.Next);
            if (isPlain)
                Sync.VolatileWrite(ref _latest, next);
            else if (Sync.CompareExchange(ref _latest, next, word) != word)
                continue;
            spares.Replace(LatestSlot.IndexOf(word));
            return version;
        }
    }

    private int LoadInto(ref TwoWordsCopier copier)
    {
        for (int i = 0; i < scenario.Tries || fault == SeededSlotFault.NeverPins; i++)
        {
            long word = Sync.VolatileRead(ref _latest);
            TwoWords slot = _slots[LatestSlot.IndexOf(word)];
            copier.CopyFrom(slot);
            if (fault != SeededSlotFault.NoLoadBarrier)
                Sync.LoadBarrier();
            int version = fault == SeededSlotFault.NoLoadBarrier
                ? Sync.Read(ref slot.Version)
                : Sync.VolatileRead(ref slot.Version);
            if (version == LatestSlot.VersionOf(word))
                return version;
        }

        bool demands = scenario is { IsAlone: true, Tries: > 0 };
        if (demands)
        {
            Add(ref _demanded, 1);
            if (fault != SeededSlotFault.DemandWithoutAFence)
                Sync.FenceAllThreads();
        }

        int pinned = LoadPinned(ref copier);
        if (demands)
            Add(ref _demanded, -1);
        return pinned;
    }

    private int LoadPinned(ref TwoWordsCopier copier)
    {
        while (true)
        {
            long word = Sync.VolatileRead(ref _latest);
            TwoWords slot = _slots[LatestSlot.IndexOf(word)];
            bool isLatest = fault == SeededSlotFault.RecheckBeforeThePin && Sync.VolatileRead(ref _latest) == word;
            bool isFirst = Add(ref slot.Pins, 1) == 1;
            if (fault != SeededSlotFault.RecheckBeforeThePin)
                isLatest = fault == SeededSlotFault.PinWithoutARecheck || Sync.VolatileRead(ref _latest) == word;
            if (fault == SeededSlotFault.PinsAlone)
                isLatest &= isFirst;
            if (isLatest && fault != SeededSlotFault.UnpinBeforeTheCopy)
                copier.CopyFrom(slot);
            Add(ref slot.Pins, -1);
            if (!isLatest)
                continue;
            if (fault == SeededSlotFault.UnpinBeforeTheCopy)
                copier.CopyFrom(slot);
            return LatestSlot.VersionOf(word);
        }
    }

    private static int Add(ref int location, int change)
    {
        int found;
        do
            found = Sync.VolatileRead(ref location);
        while (Sync.CompareExchange(ref location, found + change, found) != found);
        return found + change;
    }
}
