using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>The global copy of a message whose class copies itself, without a lock.</summary>
/// <remarks>
/// The copy method is the user's: it may take long, and it may throw half-way. So it never runs on an instance that
/// another thread changes, and no one waits for it: a post copies into a spare slot and then makes that the latest,
/// a fetch pins the latest slot while it copies from it (<see cref="SlotPool{TSlot, TSync}"/>) into the second
/// instance of its local copy, which it then exchanges. A copy that failed leaves every copy with its whole
/// previous value. Nothing is allocated after wiring, but where more fetchers copy at once than there were before.
/// </remarks>
internal sealed class SharedObject<T> : SharedMessage<T>
{
    // One to write while the one before is still read.
    private const int SparesOfPoster = 2;

    private readonly SlotPool<ValueSlot<T>, SyncPoints> _pool;
    private readonly T _initial;   // read only

    public SharedObject(MessagePlace place, T initial)
        : base(place, firstVersion: 0)
    {
        _initial = CloneOf(initial);
        _pool = new SlotPool<ValueSlot<T>, SyncPoints>(NewSlot(), NewSlot);
    }

    public override LocalCopy<T> CreateCopy() => new(CloneOf(_initial)) { Spare = CloneOf(_initial) };

    public override MessageStamp ReadStamp()
    {
        ValueSlot<T> slot = _pool.Pin(ref Latest.Word, out int version);
        var stamp = new MessageStamp(version, slot.Time);
        SlotPool<ValueSlot<T>, SyncPoints>.Unpin(slot);
        return stamp;
    }

    public override void Assign(LocalCopy<T> copy, in T value)
    {
        if (ReferenceEquals(value, copy.Value))
            return;
        Copy(copy, value, copy.Spare, "posted");
        (copy.Value, copy.Spare) = (copy.Spare, copy.Value);
    }

    protected override SpareSlots NewSpares(bool isOutside) => _pool.NewSpares(SparesOfPoster, isOutside);

    protected override int Store(LocalCopy<T> copy, SpareSlots spares, TimeSpan time)
    {
        ValueSlot<T> slot = _pool.Take(spares);
        Copy(copy, copy.Value, slot.Value, "posted");
        slot.Time = time;
        return SlotPool<ValueSlot<T>, SyncPoints>.Publish(slot, spares, ref Latest.Word);
    }

    protected override int Load(LocalCopy<T> copy)
    {
        ValueSlot<T> slot = _pool.Pin(ref Latest.Word, out int version);
        try
        {
            Copy(copy, slot.Value, copy.Spare, "fetched");
            copy.Time = slot.Time;
        }
        finally
        {
            SlotPool<ValueSlot<T>, SyncPoints>.Unpin(slot);
        }

        (copy.Value, copy.Spare) = (copy.Spare, copy.Value);
        return version;
    }

    private static T CloneOf(T value) => ((ISelfCopying<T>)value!).Clone();

    private ValueSlot<T> NewSlot() => new() { Value = CloneOf(_initial) };

    private void Copy(LocalCopy<T> copy, T from, T to, string verb)
    {
        if (copy.IsCopying)
            throw new InvalidOperationException(
                $"{Type}.{nameof(ISelfCopying<>.CopyTo)} uses message '{Name}', which it is copying.");
        if (from is null || to is null)
            throw new InvalidOperationException($"Message '{Name}' cannot be {verb}: its value is null.");
        copy.IsCopying = true;
        try
        {
            ((ISelfCopying<T>)from).CopyTo(to);
        }
        catch (Exception e)
        {
            // Thrown to the caller that posts or fetches, with the names that the user's exception lacks.
            throw new InvalidOperationException(
                $"Message '{Name}' could not be {verb}: {Type}.{nameof(ISelfCopying<>.CopyTo)} threw "
                    + ExceptionText.Describe(e), e);
        }
        finally
        {
            copy.IsCopying = false;
        }
    }

    private static string Type => TypeNames.Of(typeof(T));
}
