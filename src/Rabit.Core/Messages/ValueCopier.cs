using System;

namespace Rabit.Core.Messages;

/// <summary>Between a slot and a local copy. For the owner's thread.</summary>
/// <param name="copy">The local copy.</param>
/// <param name="time">The time of what is posted.</param>
internal readonly struct ValueCopier<T>(LocalCopy<T> copy, TimeSpan time = default) : ISlotCopier<ValueSlot<T>>
{
    public void CopyTo(ValueSlot<T> slot)
    {
        slot.Value = copy.Value;
        slot.Time = time;
    }

    public void CopyFrom(ValueSlot<T> slot)
    {
        copy.Value = slot.Value;
        copy.Time = slot.Time;
    }
}
