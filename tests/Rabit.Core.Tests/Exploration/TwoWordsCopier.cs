using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Copies two words, each by a plain access.</summary>
internal struct TwoWordsCopier(int value) : ISlotCopier<TwoWords>
{
    public int First { get; private set; } = value;

    public int Second { get; private set; } = value;

    /// <summary>How often a value was copied from a slot.</summary>
    public int Copies { get; private set; }

    public readonly void CopyTo(TwoWords slot)
    {
        default(ExploredSyncPoints).Write(ref slot.First, First);
        default(ExploredSyncPoints).Write(ref slot.Second, Second);
    }

    public void CopyFrom(TwoWords slot)
    {
        Copies++;
        First = default(ExploredSyncPoints).Read(ref slot.First);
        Second = default(ExploredSyncPoints).Read(ref slot.Second);
    }
}
