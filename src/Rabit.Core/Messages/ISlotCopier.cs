namespace Rabit.Core.Messages;

/// <summary>
/// Copies a value between a slot and where it comes from or goes to. A struct, so that the call is inlined.
/// </summary>
internal interface ISlotCopier<TSlot>
    where TSlot : Slot
{
    void CopyTo(TSlot slot);

    /// <summary>The slot may change meanwhile: what was copied counts only if it turns out to be whole.</summary>
    void CopyFrom(TSlot slot);
}
