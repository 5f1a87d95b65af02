namespace Rabit.Core.Managers;

/// <summary>
/// A place on the stack of a thread: here nothing says how much of it is left, so there are no marks, and the
/// thread-static field decides (<see cref="RunningManager"/>).
/// </summary>
internal readonly struct StackMark
{
    /// <summary>Whether the stack can be marked.</summary>
    public const bool Exists = false;

    public bool IsSet => false;

    public static StackMark At(ref StackMark local) => local;

    public bool Covers(ref StackMark local) => local.IsSet;

    public bool IsHere() => false;

    public bool IsSameAs(StackMark other) => !other.IsSet;
}
