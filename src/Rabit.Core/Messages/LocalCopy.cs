using System;

namespace Rabit.Core.Messages;

/// <summary>
/// A manager's own copy of a message, behind all its endpoints for it. Touched by its owner's thread only.
/// </summary>
internal sealed class LocalCopy<T>(T value)
{
    public T Value = value;

    /// <summary>
    /// The second instance of a class that copies itself: filled in by a fetch while <see cref="Value"/> stays whole.
    /// </summary>
    public T Spare = default!;

    /// <summary>Whether a class that copies itself is doing so, from or to this copy.</summary>
    public bool IsCopying;

    /// <summary>The slots that a poster may write; null where the owner has not posted yet and need not.</summary>
    public SpareSlots? Spares;

    /// <summary>The version of the last post that the owner fetched or made.</summary>
    public int SeenVersion;

    /// <summary>The time of that post.</summary>
    public TimeSpan Time;

    /// <summary>Posts of others that the owner's own posts covered before they were fetched.</summary>
    public int CoveredPosts;

    public MessageStamp Stamp => new(SeenVersion, Time);
}
