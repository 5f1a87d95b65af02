using System;
using System.Diagnostics.CodeAnalysis;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Diagnostics;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>
/// The hidden global copy that joins the local copies of a message: its versions, and the subscribers to notify of a
/// post.
/// </summary>
/// <remarks>
/// The version is all that a fetch without news looks at: one volatile read. It is 32 bits wide, because wider reads
/// are not atomic on 32-bit boards. How the value is kept whole is for the derived classes
/// (<see cref="SlotPool{TSlot, TSync}"/>).
/// </remarks>
[SuppressMessage("Reliability", "CA1001:Types that own disposable fields should be disposable",
    Justification = "A source of cancellation without a timer or a wait handle holds nothing that must be released.")]
internal abstract class SharedMessage<T>(MessagePlace place, int firstVersion)
    : IConnector, IObservedMessage, ISubscriptions<SyncPoints>
{
    private readonly object _targetsGate = new();
    private readonly CancellationTokenSource _closed = new();
    private PostTarget[] _targets = []; // replaced whole under _targetsGate, read by posters
    private int _lastVersion;           // of the run; written before _closed is cancelled, read after that

    /// <summary>Written by posters, read by all; guarded as <see cref="SlotPool{TSlot, TSync}"/> says.</summary>
    protected LatestSlot Latest = new(firstVersion, index: 0);

    public string Name { get; } = place.Name;

    public RunClock Clock { get; } = place.Clock;

    public int Version => Volatile.Read(ref Latest.Version);

    public abstract LocalCopy<T> CreateCopy();

    /// <summary>Gives a local copy what it takes to post, so that no post allocates it.</summary>
    public SpareSlots Equip(LocalCopy<T> copy, EndpointOwner poster)
        => copy.Spares ??= NewSpares(isOutside: !poster.IsManager);

    /// <summary>Version and time of the latest post, without its value.</summary>
    public abstract MessageStamp ReadStamp();

    public MessageObserver Observe() => new TypedMessageObserver<T>(this);

    void ISubscriptions<SyncPoints>.Add(Subscription<SyncPoints> subscription)
    {
        lock (_targetsGate)
            Volatile.Write(ref _targets, [.. _targets, (PostTarget)subscription]);
    }

    void ISubscriptions<SyncPoints>.Remove(Subscription<SyncPoints> subscription)
    {
        lock (_targetsGate)
            Volatile.Write(ref _targets, Array.FindAll(_targets, t => t != subscription));
    }

    /// <summary>
    /// Waits until a local copy is no longer the latest; for async code outside managers. It is a target of posts while
    /// it waits and no longer.
    /// </summary>
    /// <remarks>
    /// The race it closes: a poster reads the targets before this one is among them, and the waiter reads the version
    /// before that of the post is there. Each does one of the two and then looks at the other; between them both need a
    /// full fence, which the waiter makes for both.
    /// </remarks>
    /// <returns>False when the run is over and there is no news from before its end.</returns>
    public async Task<bool> WaitForNewsAsync(LocalCopy<T> copy, EndpointOwner owner, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        var news = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var target = new PostTarget(owner, wakeUp: null, _ => news.TrySetResult(true));
        target.Join(this);
        default(SyncPoints).FenceAllThreads();
        if (HasNews(copy))
            return true;
        using (_closed.Token.Register(() => news.TrySetResult(false)))
        using (cancellation.Register(() => news.TrySetCanceled(cancellation)))
        {
            bool wasPosted = await news.Task.ConfigureAwait(false);
            return (wasPosted && !_closed.IsCancellationRequested) || HasNews(copy);
        }
    }

    /// <summary>
    /// The run is over: nothing waits for news any more, and what code outside managers still posts is news to none
    /// that wait. A post that races with this is from before the end or from after it.
    /// </summary>
    public void Close()
    {
        if (_closed.IsCancellationRequested)
            return;
        _lastVersion = Version;
        _closed.Cancel();
    }

    /// <summary>Whether a version was posted after the end of the run.</summary>
    public bool IsAfterTheEnd(int version)
        => _closed.IsCancellationRequested && unchecked(version - _lastVersion) > 0;

    /// <summary>Copies a value that the owner of a local copy gives to that local copy.</summary>
    public virtual void Assign(LocalCopy<T> copy, in T value) => copy.Value = value;

    /// <summary>
    /// Copies a local copy to the global one, and wakes the subscribers and calls the handlers that asked for it.
    /// </summary>
    /// <param name="copy">What is posted.</param>
    /// <param name="poster">Who posts.</param>
    /// <param name="time">The stamp.</param>
    /// <param name="now">
    /// The time now, where the poster has just read it: the woken manager need not read the clock again.
    /// </param>
    /// <exception cref="InvalidOperationException">
    /// Code outside managers posts through one endpoint on two threads at once.
    /// </exception>
    public void Post(LocalCopy<T> copy, EndpointOwner poster, TimeSpan time, TimeSpan? now = null)
    {
        SpareSlots spares = copy.Spares ?? Equip(copy, poster);
        int version = poster.IsManager ? Store(copy, spares, time) : StoreOutside(copy, spares, time);
        int covered = PostsBetween(copy.SeenVersion, version) - 1;
        if (covered != 0)
            copy.CoveredPosts += covered;
        copy.SeenVersion = version;
        copy.Time = time;

        foreach (PostTarget target in Volatile.Read(ref _targets))
        {
            // One's own post is not news to oneself.
            if (target.Owner == poster)
                continue;
            if (target.WakeUp is { } sleeper)
                Wake(sleeper, now);
            if (target.Handler is { } handler && !target.HasEnded)
            {
                Call(handler, target, copy.Stamp);
                now = null;   // it took its time
            }
        }
    }

    /// <summary>Copies the global to a local copy.</summary>
    /// <returns>How many posts the owner had not seen, the fetched one included.</returns>
    public int Fetch(LocalCopy<T> copy)
    {
        int version = Load(copy);
        int news = PostsBetween(copy.SeenVersion, version);
        copy.SeenVersion = version;
        if (news == 0)
            return 0;
        news += copy.CoveredPosts;
        copy.CoveredPosts = 0;
        return news;
    }

    protected abstract SpareSlots NewSpares(bool isOutside);

    /// <summary>Copies a local copy's value to the global one, as the next version.</summary>
    /// <returns>That version.</returns>
    protected abstract int Store(LocalCopy<T> copy, SpareSlots spares, TimeSpan time);

    /// <summary>Copies value and time of the latest version, whole, to a local copy.</summary>
    /// <returns>That version.</returns>
    protected abstract int Load(LocalCopy<T> copy);

    // Of code outside managers, which nothing but its documentation holds to one thread at a time.
    private int StoreOutside(LocalCopy<T> copy, SpareSlots spares, TimeSpan time)
    {
        if (!spares.TryEnter())
            throw new InvalidOperationException(
                $"Two threads post message '{Name}' at once through one endpoint: each needs an endpoint of its own.");
        try
        {
            return Store(copy, spares, time);
        }
        finally
        {
            spares.Exit();
        }
    }

    // The version before the end: who sees a version from after the end sees the end too.
    private bool HasNews(LocalCopy<T> copy)
    {
        int version = Version;
        return version != copy.SeenVersion && !IsAfterTheEnd(version);
    }

    private static void Wake(WakeUpEvent sleeper, TimeSpan? now)
    {
        if (now is { } time)
            sleeper.Wake(WakeUpCauses.Post, time);
        else
            sleeper.Wake(WakeUpCauses.Post);
    }

    private void Call(Action<MessageStamp> handler, PostTarget target, MessageStamp stamp)
    {
        try
        {
            handler(stamp);
        }
        catch (Exception e)
        {
            // A handler is the subscriber's code on the poster's thread: it may not harm the poster.
            place.Log.Write(
                RabitLogKind.Fault, target.Owner.Name,
                $"the post handler of message '{Name}' threw {ExceptionText.Describe(e)}", e);
        }
    }

    private static int PostsBetween(int seen, int version)
    {
        int posts = unchecked(version - seen);
        return seen < 0 && version > 0 ? posts - 1 : posts;
    }
}
