namespace Rabit.Core.Messages;

/// <summary>
/// Where a post is kept: the latest one, or one that may be written over (<see cref="SlotPool{TSlot, TSync}"/>).
/// </summary>
internal class Slot
{
    /// <summary>
    /// The version of the post in it, from before its value is written. Written by the poster whose slot it is, read by
    /// all.
    /// </summary>
    public int Version;

    /// <summary>
    /// How many fetchers read it now, and must not have it written over. Changed by them, interlocked.
    /// </summary>
    public int Pins;
}
