using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <content>Readers and async code that wait: for room (back-pressure), or for something to pop. Tasks are completed
/// outside the lock.</content>
internal sealed partial class LockedQueue<T> : ITimeLimitedQueue
{
    private readonly TaskCompletionSource<bool> _drained = new(TaskCreationOptions.RunContinuationsAsynchronously);

    // All under _gate. Pushes wait only while the queue is full: the pop that makes room hands it to the first of them.
    private WakeUpEvent? _waitingReader;
    private List<PendingPush<T>>? _pending;
    private AsyncWaiters? _room;
    private AsyncWaiters? _news;
    private bool _hasWaiters;   // for a pop

    /// <inheritdoc/>
    public WakeUpEvent? TimeKeeper { private get; set; }

    /// <summary>Completes when the run is over and everything was popped.</summary>
    public Task Drained => _drained.Task;

    /// <summary>
    /// Puts a value in, or notes which reader waits for room: the next pop wakes it. Nothing is counted as rejected.
    /// </summary>
    public bool TryPushOrWait(in T value, WakeUpEvent reader)
    {
        var announcement = default(Announcement);
        using (_gate.Enter())
        {
            if (_count == _ring.Length || _isClosed)
            {
                // One reader feeds one queue, so there is never a second one to remember.
                _waitingReader = reader;
                _hasWaiters = true;
                return false;
            }

            PutIn(value, ref announcement);
        }

        Announce(announcement);
        return true;
    }

    /// <summary>A reader has waited for too long.</summary>
    public void GiveUp()
    {
        using (_gate.Enter())
        {
            _waitingReader = null;
            _rejected++;
        }
    }

    /// <summary>
    /// Puts a value in; where the rule is not to drop, it waits for room. A push that was not put in stays the
    /// sender's.
    /// </summary>
    public ValueTask<PushResult> PushAsync(T value, CancellationToken cancellation)
    {
        if (cancellation.IsCancellationRequested)
            return new ValueTask<PushResult>(Task.FromCanceled<PushResult>(cancellation));
        if (Drops)
            return new ValueTask<PushResult>(Push(value));

        PushResult result = PushResult.Queued;
        PendingPush<T>? pending = null;
        var announcement = default(Announcement);
        using (_gate.Enter())
        {
            if (HasRoom || _isClosed)
                result = Admit(value, ref announcement);
            else
                pending = Enlist(value);
        }

        if (pending is not null)
            return new ValueTask<PushResult>(Await(pending, cancellation));
        Announce(announcement);
        return new ValueTask<PushResult>(result);
    }

    /// <returns>True when there may be room now; false when there will never be any.</returns>
    public ValueTask<bool> WaitForRoomAsync(CancellationToken cancellation)
    {
        TaskCompletionSource<bool> waiter;
        using (_gate.Enter())
        {
            if (_isClosed || Drops || HasRoom)
                return new ValueTask<bool>(!_isClosed);
            waiter = (_room ??= new AsyncWaiters()).Add();
            _hasWaiters = true;
        }

        return Await(waiter, cancellation);
    }

    /// <returns>True when there may be something to pop now; false when there will never be anything.</returns>
    public ValueTask<bool> WaitForNewsAsync(CancellationToken cancellation)
    {
        TaskCompletionSource<bool> waiter;
        using (_gate.Enter())
        {
            if (_isClosed || _count > 0)
                return new ValueTask<bool>(_count > 0);
            waiter = (_news ??= new AsyncWaiters()).Add();
        }

        return Await(waiter, cancellation);
    }

    /// <inheritdoc/>
    public TimeSpan ExpirePushes(TimeSpan now)
    {
        List<PendingPush<T>>? expired = null;
        TimeSpan next = TimeSpan.MaxValue;
        using (_gate.Enter())
        {
            foreach (PendingPush<T> pending in _pending ?? [])
            {
                if (pending.Due > now)
                    next = pending.Due < next ? pending.Due : next;
                else if (pending.TryClaim())
                    (expired ??= []).Add(pending);
            }

            _rejected += expired?.Count ?? 0;
            ForgetEnded();
        }

        foreach (PendingPush<T> pending in expired ?? [])
            pending.TrySetResult(PushResult.TimedOut);
        return next;
    }

    private bool Drops => FullMode is QueueFullMode.DropOldest or QueueFullMode.DropNewest;

    // Under _gate. Who came first and waits goes first.
    private bool HasRoom => _count < _ring.Length && _pending is null;

    private PendingPush<T> Enlist(T value)
    {
        var pending = new PendingPush<T>(value, Times.Later(clock.Now, MaxWait ?? TimeSpan.MaxValue));
        (_pending ??= []).Add(pending);
        _hasWaiters = true;
        return pending;
    }

    private async Task<PushResult> Await(PendingPush<T> pending, CancellationToken cancellation)
    {
        TimeKeeper?.Wake(WakeUpCauses.Request);
        using (cancellation.Register(() => Cancel(pending, cancellation)))
            return await pending.Task.ConfigureAwait(false);
    }

    // Let go of at once: who waits in vain, and is cancelled again and again, must not fill the memory.
    private void Cancel(PendingPush<T> pending, CancellationToken cancellation)
    {
        if (!pending.TryClaim())
            return;
        using (_gate.Enter())
            ForgetEnded();
        pending.TrySetCanceled(cancellation);
    }

    private static async ValueTask<bool> Await(TaskCompletionSource<bool> waiter, CancellationToken cancellation)
    {
        using (cancellation.Register(() => waiter.TrySetCanceled(cancellation)))
            return await waiter.Task.ConfigureAwait(false);
    }

    /// <summary>
    /// After a pop: wakes a reader that waits for room, gives the room to the first waiting push, or releases all
    /// waiters.
    /// </summary>
    private void ServeWaiting()
    {
        WakeUpEvent? reader;
        AsyncWaiters? room = null;
        PendingPush<T>? admitted = null;
        var announcement = default(Announcement);
        bool drained;
        using (_gate.Enter())
        {
            reader = _waitingReader;
            _waitingReader = null;
            admitted = _count < _ring.Length ? ClaimFirst() : null;
            if (admitted is not null)
                PutIn(admitted.Value, ref announcement);
            if (HasRoom)
            {
                room = _room;
                _room = null;
            }

            drained = _isClosed && _count == 0;
            _hasWaiters = _isClosed || _pending is not null || _room is not null;
        }

        reader?.Wake(WakeUpCauses.Pop);
        admitted?.TrySetResult(PushResult.Queued);
        Announce(announcement);
        room?.Release(true);
        if (drained)
            _drained.TrySetResult(true);
    }

    private void EndWaiting()
    {
        List<PendingPush<T>> rejected;
        AsyncWaiters? room;
        AsyncWaiters? news;
        bool drained;
        using (_gate.Enter())
        {
            _isClosed = true;
            _hasWaiters = true;   // for the end of what is left
            rejected = (_pending ?? []).FindAll(p => p.TryClaim());
            _rejected += rejected.Count;
            _pending = null;
            room = _room;
            _room = null;
            news = TakeNews();
            drained = _count == 0;
        }

        foreach (PendingPush<T> pending in rejected)
            pending.TrySetResult(PushResult.Rejected);
        room?.Release(false);
        news?.Release(false);
        if (drained)
            _drained.TrySetResult(true);
    }

    private PendingPush<T>? ClaimFirst()
    {
        PendingPush<T>? first = _pending?.Find(p => p.TryClaim());
        ForgetEnded();
        return first;
    }

    private void ForgetEnded()
    {
        _pending?.RemoveAll(p => p.IsClaimed);
        if (_pending?.Count == 0)
            _pending = null;
    }

    private AsyncWaiters? TakeNews()
    {
        AsyncWaiters? news = _news;
        _news = null;
        return news;
    }
}
