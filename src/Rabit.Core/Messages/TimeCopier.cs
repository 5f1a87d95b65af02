using System;

namespace Rabit.Core.Messages;

/// <summary>The time of a post, without its value.</summary>
internal struct TimeCopier<T> : ISlotCopier<ValueSlot<T>>
{
    public TimeSpan Time { get; private set; }

    public readonly void CopyTo(ValueSlot<T> slot) => slot.Time = Time;

    public void CopyFrom(ValueSlot<T> slot) => Time = slot.Time;
}
