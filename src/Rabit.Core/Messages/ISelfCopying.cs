namespace Rabit.Core;

/// <summary>
/// A message class that can be changed and knows how to copy itself: for messages with arrays or lists in them that
/// should not be allocated again for each post. Sealed, and implemented for itself:
/// <c>sealed class Scan : ISelfCopying&lt;Scan&gt;</c>. Every manager then has instances of its own, all made when the
/// run starts, and a post or a fetch copies from one into another.
/// </summary>
/// <typeparam name="TSelf">The class itself.</typeparam>
/// <remarks>
/// Both methods are called on the thread that starts, posts or fetches; several threads may copy from one instance
/// at a time, and none changes it meanwhile, nor sees the one that is copied into. So they copy, and do nothing
/// else: they do not change the instance that they copy from. After them the two share nothing that can be changed.
/// What they throw reaches the one who posted or fetched as an <see cref="System.InvalidOperationException"/> that
/// names the message; all copies keep the whole value of before.
/// </remarks>
public interface ISelfCopying<TSelf>
{
    /// <summary>
    /// Makes a new instance that equals this one. Called when the run starts, and for subscribers that come later.
    /// </summary>
    TSelf Clone();

    /// <summary>
    /// Makes another instance equal to this one, whatever it held before. Allocates nothing, if posts are to allocate
    /// nothing.
    /// </summary>
    /// <param name="target">Never this instance.</param>
    void CopyTo(TSelf target);
}
