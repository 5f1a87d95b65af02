using System;

namespace Rabit.Core.Messages;

/// <summary>A slot with a value and its time. Guarded as <see cref="SlotPool{TSlot, TSync}"/> says.</summary>
internal sealed class ValueSlot<T> : Slot
{
    public TimeSpan Time;
    public T Value = default!;
}
