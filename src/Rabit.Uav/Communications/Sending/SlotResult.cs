namespace Rabit.Uav.Communications;

/// <summary>What became of a value that was put into a slot.</summary>
internal enum SlotResult
{
    /// <summary>It waits.</summary>
    Added,

    /// <summary>It waits in the place of an older one.</summary>
    Replaced,

    /// <summary>There are too many pieces of state.</summary>
    NoRoom,
}
