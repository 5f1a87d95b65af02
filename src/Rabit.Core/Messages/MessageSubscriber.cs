using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Messages;
using Rabit.Core.Time;

namespace Rabit.Core;

/// <summary>
/// The endpoint of a publish-subscribe message that fetches: ask whether there is news, then read the local copy. Made
/// by <see cref="RabitManager.Subscribe{T}(string, bool, bool)"/>, or by
/// <see cref="RabitWorkspace.Subscribe{T}(string)"/> for code outside managers.
/// </summary>
/// <typeparam name="T">
/// A struct with value semantics, an immutable class, or a class that copies itself
/// (<see cref="ISelfCopying{TSelf}"/>).
/// </typeparam>
/// <remarks>
/// Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.
/// </remarks>
/// <example>
/// <code>
/// if (_pose.Fetch())                       // is there news?
///     Steer(_pose.Value.NorthMetres);
///
/// if (!_pose.IsFresh(TimeSpan.FromSeconds(1)))
///     Stop();                              // the last one is too old to act on
/// </code>
/// </example>
public sealed class MessageSubscriber<T>
{
    private readonly MessageBinding<T> _binding;

    internal MessageSubscriber(MessageBinding<T> binding) => _binding = binding;

    /// <summary>The name of the message.</summary>
    public string Name => _binding.Name;

    /// <summary>
    /// The local copy, by reference: it changes at a fetch and at no other time. Of a class that copies itself it may
    /// be another instance after each fetch: use it through this property, do not keep it.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// The endpoint's manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public ref readonly T Value
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref _binding.Copy().Value;
    }

    /// <summary>The stamp of the value; version zero before anything was fetched.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public MessageStamp Stamp => _binding.Copy().Stamp;

    /// <summary>Whether the message was ever posted, fetched or not.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public bool WasPosted
    {
        get
        {
            _binding.Copy();
            return _binding.Shared!.Version != 0;
        }
    }

    /// <summary>
    /// How long ago the fetched value was true; <see cref="TimeSpan.MaxValue"/> before anything was fetched, or where
    /// that is longer than a time can be. Negative where its poster gave a time that has not come yet.
    /// </summary>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public TimeSpan Age
    {
        get
        {
            LocalCopy<T> copy = _binding.Copy();
            return copy.SeenVersion == 0 ? TimeSpan.MaxValue : Times.Since(_binding.Shared!.Clock.Now, copy.Time);
        }
    }

    /// <summary>Whether the fetched value is there and not too old to act on. It does not fetch.</summary>
    /// <param name="maxAge">
    /// How old it may be, by its stamp. A value that is true at this very moment has the age zero; one whose stamp lies
    /// in the future is not fresh: nothing is known of its age.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">The age is negative.</exception>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public bool IsFresh(TimeSpan maxAge)
    {
        if (maxAge < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(maxAge), maxAge, $"The maximum age of message '{Name}' cannot be negative.");
        TimeSpan age = Age;
        return age >= TimeSpan.Zero && age <= maxAge && Stamp.Version != 0;
    }

    /// <summary>Copies the global to the local copy if it is newer.</summary>
    /// <returns>True when it was: the value is news. One's own post is not.</returns>
    /// <remarks>Allocates nothing. When there is no news it takes no lock and copies nothing.</remarks>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Fetch()
    {
        LocalCopy<T> copy = _binding.Copy();
        SharedMessage<T> shared = _binding.Shared!;
        return shared.Version != copy.SeenVersion && shared.Fetch(copy) != 0;
    }

    /// <summary>
    /// As <see cref="Fetch()"/>, and hands out the local copy: for languages and closures without references.
    /// </summary>
    /// <param name="value">
    /// The local copy, news or not. Of a class that copies itself it is the local instance, valid until the next fetch.
    /// </param>
    /// <returns>True when it is news.</returns>
    /// <remarks>
    /// As <see cref="Fetch()"/>; a large struct is copied once more, which <see cref="Value"/> spares.
    /// </remarks>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public bool Fetch(out T value)
    {
        LocalCopy<T> copy = _binding.Copy();
        SharedMessage<T> shared = _binding.Shared!;
        bool isNews = shared.Version != copy.SeenVersion && shared.Fetch(copy) != 0;
        value = copy.Value;
        return isNews;
    }

    /// <summary>As <see cref="Fetch()"/>, and returns how many posts were missed since the last one.</summary>
    /// <param name="missed">
    /// Posts of others that were overwritten before this endpoint fetched them; zero when there is no news.
    /// </param>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public bool FetchAndCountMissed(out int missed)
    {
        LocalCopy<T> copy = _binding.Copy();
        SharedMessage<T> shared = _binding.Shared!;
        int news = shared.Version == copy.SeenVersion ? 0 : shared.Fetch(copy);
        missed = news > 1 ? news - 1 : 0;
        return news != 0;
    }

    /// <summary>
    /// Copies the global to the local copy, newer or not: what was changed or covered locally is undone.
    /// </summary>
    /// <returns>True when it was news.</returns>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public bool ForceFetch()
    {
        LocalCopy<T> copy = _binding.Copy();
        return _binding.Shared!.Fetch(copy) != 0;
    }

    /// <summary>
    /// Waits for news without a thread, for async code outside managers: <see cref="Fetch()"/> follows. Posts that come
    /// before that merge, as wake-ups do.
    /// </summary>
    /// <param name="cancellationToken">Ends the wait; the task is cancelled then.</param>
    /// <returns>
    /// True when there is news; false when the run is over and there is none: what code outside managers posts after
    /// the end is not.
    /// </returns>
    /// <exception cref="InvalidOperationException">
    /// The endpoint belongs to a manager, which sleeps until a post wakes it instead, or nothing is wired yet.
    /// </exception>
    public Task<bool> WaitForNewsAsync(CancellationToken cancellationToken = default)
    {
        _binding.DemandOutside();
        LocalCopy<T> copy = _binding.Copy();
        return _binding.Shared!.WaitForNewsAsync(copy, _binding.Owner, cancellationToken);
    }

    /// <summary>
    /// The values as they are posted, for async code outside managers: the latest one each time, so that a reader that
    /// is slower than the posts skips some. It begins with the value that was posted last, if it was not fetched yet,
    /// and ends with the run, also where code outside managers still posts: its value from after the end is not given.
    /// </summary>
    /// <param name="cancellationToken">Ends the wait for the next one with an exception.</param>
    /// <remarks>
    /// For an <c>await foreach</c>. It holds on to the message only while it waits. The instance of a class that copies
    /// itself is valid until the next one.
    /// </remarks>
    /// <exception cref="InvalidOperationException">See <see cref="WaitForNewsAsync"/>.</exception>
    public IAsyncEnumerable<T> ReadAllAsync(CancellationToken cancellationToken = default)
    {
        _binding.DemandOutside();
        return ReadAll(cancellationToken);
    }

    private async IAsyncEnumerable<T> ReadAll([EnumeratorCancellation] CancellationToken cancellationToken)
    {
        while (await WaitForNewsAsync(cancellationToken).ConfigureAwait(false))
        {
            // The run may have ended since, and the value that it ended with may be covered by a later one.
            if (Fetch(out T value) && !_binding.Shared!.IsAfterTheEnd(_binding.Copy().SeenVersion))
                yield return value;
        }
    }

    /// <summary>
    /// Calls a handler at every post of others, on the poster's thread, after every lock is released. The handler may
    /// not touch the endpoints of a manager, this one included: where a manager posts, its thread runs the handler, and
    /// what is the handler's mistake would pass for the manager's own use. It should be short. One that throws is
    /// reported.
    /// </summary>
    /// <param name="handler">Given the stamp of the post.</param>
    /// <returns>
    /// The subscription; dispose it, on any thread, to end it. Until then the message keeps the handler, and what the
    /// handler holds. A post that is under way on another thread at that moment may still call it once.
    /// </returns>
    public IDisposable OnPost(Action<MessageStamp> handler)
        => _binding.AddHandler(Require.NotNull(handler, nameof(handler)));
}
