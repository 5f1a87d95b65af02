using System;
using System.Threading;
using Rabit.Core.Locks;

namespace Rabit.Core.Messages;

/// <summary>
/// The global copy of a struct, or of the reference to an immutable object, with the last few posts beside the latest.
/// </summary>
/// <remarks>
/// Requirements (contract 2.2 to 2.5): no torn read: a value that a fetch returns was posted, whole, with its time and
/// its version, on any processor; never one older than the version that made the fetch look; nothing is allocated;
/// neither posters nor fetchers are starved; a thread that is pushed off its processor in the middle of a post or a
/// fetch blocks no other thread for good.
/// <para>
/// A seqlock over a few slots: each post goes into the next slot and then becomes the latest version. A fetcher copies
/// the slot of the latest version, and then looks whether a post has begun in that slot meanwhile; if so, the value was
/// overwritten, and it discards its copy and tries again. A poster that is pushed off its processor half-way leaves the
/// latest version whole, so no fetcher ever waits for it.
/// </para>
/// <para>
/// The race: a fetcher copies a slot while a poster that has come all the way around writes it. The poster writes, in
/// this order, <c>Begun</c>, the value, the version. The fetcher reads, in this order, the version, the value,
/// <c>Begun</c>. If it read any part of a later value, it also reads a <c>Begun</c> that is not its version. Memory
/// order: a store barrier after <c>Begun</c>, release of the version; acquire of the version, a load barrier before
/// <c>Begun</c>. x86 keeps these orders by itself, so that the barriers bind the compiler only; Arm needs them, and
/// needs no more.
/// </para>
/// <para>
/// A copy that is thrown away does no harm even if it holds references: the runtime copies each reference in one piece,
/// so each was posted, though they may not belong together; and it lies in the fetcher's own copy, which is not read
/// before a whole one has replaced it. (The counter would have to come around, 2^32 posts within one copy, to deceive.)
/// </para>
/// <para>
/// A fetcher whose value was overwritten a few times is starved: it takes the lock and says so in
/// <c>_starvedReaders</c>; the poster looks there before each post, and takes the lock as well. There is no fence
/// between the poster's read and its writing: it may miss the mark for the few nanoseconds of one round of the slots,
/// and overwrite the fetcher's value once more; being whole never depends on it. Several posters, and those that the
/// library cannot hold to one thread (outside managers), always take the lock.
/// </para>
/// <para>
/// Measured gain over a lock alone: see decision 0010. Without cheap barriers (netstandard2.0, and so Mono, whose
/// barriers have failed on Arm before) there is one slot, and all take the lock: see <see cref="OptimisticRead"/>.
/// </para>
/// </remarks>
internal sealed class SharedValue<T> : SharedMessage<T>
{
    private readonly EndpointLock _gate;
    // written by the poster, who is alone or holds _gate; read by all, valid only after Begun was compared
    private readonly Slot[] _slots;
    private readonly T _initial;
    private readonly int _tries;
    private readonly bool _isAlone;
    private bool _starvedReaders;             // written under _gate; read by a poster that is alone

    /// <param name="place">Name, clock, log.</param>
    /// <param name="initial">The value before the first post.</param>
    /// <param name="isAlone">Whether there is one poster, which posts on one thread at a time.</param>
    /// <param name="version">The version to begin with; other than 0 for tests of the wrap-around.</param>
    /// <param name="tries">
    /// How often a fetch tries without the lock; 0 where every fetch takes it. Other than the default for tests.
    /// </param>
    public SharedValue(MessagePlace place, T initial, bool isAlone, int version = 0, int tries = OptimisticRead.Tries)
        : base(place, version)
    {
        _gate = new EndpointLock(place.InheritsPriority);
        _initial = initial;
        _tries = tries;
        _isAlone = isAlone && tries > 0;
        _slots = new Slot[tries > 0 ? OptimisticRead.Slots : 1];
        ref Slot first = ref SlotOf(version);
        first.Begun = version;
        first.Value = initial;
    }

    public override LocalCopy<T> CreateCopy() => new(_initial);

    public override MessageStamp ReadStamp()
    {
        for (int i = 0; i < _tries; i++)
        {
            if (TryReadStamp(out MessageStamp stamp))
                return stamp;
        }

        // As LoadLocked.
        using (_gate.Enter())
        {
            if (_tries == 0)
                return new MessageStamp(Version, SlotOf(Version).Time);
            Volatile.Write(ref _starvedReaders, true);
            MessageStamp stamp;
            while (!TryReadStamp(out stamp))
            {
                // See there.
            }

            Volatile.Write(ref _starvedReaders, false);
            return stamp;
        }
    }

    protected override int Store(LocalCopy<T> copy, TimeSpan time)
    {
        if (_isAlone && !Volatile.Read(ref _starvedReaders))
            return Write(copy, time);
        using (_gate.Enter())
            return Write(copy, time);
    }

    protected override int Load(LocalCopy<T> copy)
    {
        for (int i = 0; i < _tries; i++)
        {
            if (TryRead(copy, out int version))
                return version;
        }

        return LoadLocked(copy);
    }

    private int LoadLocked(LocalCopy<T> copy)
    {
        using (_gate.Enter())
        {
            int version;
            if (_tries == 0)
            {
                // All take the lock: nothing can move, and no barrier is needed.
                version = Version;
                ref Slot slot = ref SlotOf(version);
                copy.Value = slot.Value;
                copy.Time = slot.Time;
                return version;
            }

            Volatile.Write(ref _starvedReaders, true);
            while (!TryRead(copy, out version))
            {
                // Overwritten by posts that began before the poster could see the mark; the next one waits for this
                // lock.
            }

            Volatile.Write(ref _starvedReaders, false);
            return version;
        }
    }

    private int Write(LocalCopy<T> copy, TimeSpan time)
    {
        int version = NextVersion();
        ref Slot slot = ref SlotOf(version);
        slot.Begun = version;
        if (_tries > 0)
            OptimisticRead.StoreBarrier();
        slot.Value = copy.Value;
        slot.Time = time;
        Announce(version);
        return version;
    }

    private bool TryRead(LocalCopy<T> copy, out int version)
    {
        version = Version;
        ref Slot slot = ref SlotOf(version);
        copy.Value = slot.Value;
        copy.Time = slot.Time;
        OptimisticRead.LoadBarrier();
        return slot.Begun == version;
    }

    // As TryRead: the time of a slot in which a post has begun meanwhile is thrown away.
    private bool TryReadStamp(out MessageStamp stamp)
    {
        int version = Version;
        ref Slot slot = ref SlotOf(version);
        stamp = new MessageStamp(version, slot.Time);
        OptimisticRead.LoadBarrier();
        return slot.Begun == version;
    }

    private ref Slot SlotOf(int version) => ref _slots[version & (_slots.Length - 1)];

    private struct Slot
    {
        /// <summary>The version of the post that last began here.</summary>
        public int Begun;
        public TimeSpan Time;
        public T Value;
    }
}
