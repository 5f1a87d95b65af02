namespace Rabit.Core.Messaging;

/// <summary>A manager's own copy of a message, behind all its ends for it. Touched by its owner's thread only.</summary>
internal sealed class LocalCopy<T>
{
    public T Value = default!;

    /// <summary>The version of the last post that the owner fetched or made.</summary>
    public int SeenVersion;

    /// <summary>The stamp of the value, as far as it was fetched or posted.</summary>
    public MessageStamp Stamp;

    /// <summary>Posts of others that the owner's own posts covered before they were fetched.</summary>
    public int CoveredPosts;
}
