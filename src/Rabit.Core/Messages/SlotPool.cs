using System;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Messages;

/// <summary>
/// The slots of a message, and who may write and read which of them: without a lock, so that no thread waits for one
/// that was pushed off its processor.
/// </summary>
/// <remarks>
/// Requirements (contract 1.8, 2.2 to 2.5): a fetched value was posted, whole; versions only grow, one by one; no
/// poster waits for another or for a fetcher, and no fetcher for a poster; nothing is allocated but where more fetchers
/// read at once than ever before.
/// <para>
/// One slot is the latest; the word names it together with the version. All others are spares of one poster each. A
/// poster writes one of its spares and then makes it the latest by a compare-and-swap of the word; the slot that was
/// the latest becomes its spare. So no two posters ever write one slot, and the latest is never written.
/// </para>
/// <para>
/// The race that is left: a fetcher reads the slot of the latest word while that slot is replaced, becomes a spare, and
/// is written by its new owner. There are two ways to read, and each closes it:
/// </para>
/// <list type="bullet">
/// <item><b>Pinned</b> (<see cref="Pin"/>): the fetcher counts itself in at the slot, and then looks whether the slot
/// is still the latest. A poster looks at the count before it writes a spare, and takes another one where it is not
/// zero. Both have a full fence between their write and their look (the fetcher's count and the poster's swap are
/// interlocked), so one of the two sees the other.</item>
/// <item><b>Optimistic</b>, as with a seqlock (<see cref="Load"/>), for values that may be copied while they change:
/// the poster writes the slot's version before the value, the fetcher reads the value and then the version; if it read
/// any part of a later value it also finds a version that is not the one it came for. A store barrier and a load
/// barrier keep the two orders. It writes nothing, so fetchers do not hinder each other; but posts that come all the
/// way around spoil it.</item>
/// </list>
/// <para>
/// What is tried again, and how often: an optimistic read as often as it has tries; a look for the latest slot, by a
/// poster or to pin it, only where the word has changed since, that is once for each post that has come in between; a
/// count of a slot's fetchers only where another fetcher has counted. So posts and fetches are lock-free: of those that
/// hinder each other one always gets on. They are not wait-free: no number bounds the posts of the others, and with it
/// the looks; each look is a few instructions, however large the value, and the value is copied once.
/// </para>
/// <para>
/// A poster that is alone needs no compare-and-swap, and no fence as long as all fetchers read optimistically. One that
/// has to pin demands fences: from the fence that it makes for all threads on, the poster sees the demand, and
/// publishes as several do. The post that was under way then may be the last without a fence; the slot that it replaced
/// is the last of the spares, and before it comes to that the poster publishes another. (Were all others pinned, by
/// fetchers that had demanded before, that post would have had a fence itself.)
/// </para>
/// <para>
/// Versions have 32 bits and jump over 0. A poster that is held up in front of its swap while exactly 2^32 posts
/// pass, and the same slot is the latest again, would be misled.
/// </para>
/// </remarks>
internal sealed class SlotPool<TSlot, TSync>
    where TSlot : Slot
    where TSync : struct, ISyncPoints
{
    private readonly Func<TSlot> _create;
    private readonly int _tries;
    private readonly bool _isAlone;
    private TSlot[] _slots;        // replaced whole by larger ones, interlocked; what is in it stays where it is
    private int _fencesDemanded;   // by how many fetchers; changed by them, interlocked; read by a poster that is alone

    /// <param name="first">The slot that is the latest at first; its index is 0.</param>
    /// <param name="create">Makes a spare.</param>
    /// <param name="tries">How often a fetch reads optimistically before it pins.</param>
    /// <param name="isAlone">
    /// Whether there is one poster, on one thread at a time; only where a fetch tries, and a fence for all threads is
    /// there.
    /// </param>
    public SlotPool(TSlot first, Func<TSlot> create, int tries = 0, bool isAlone = false)
    {
        _create = create;
        _tries = tries;
        _isAlone = isAlone && tries > 0;
        _slots = [first];
    }

    /// <summary>Makes the spares of one poster.</summary>
    /// <param name="count">How many.</param>
    /// <param name="isOutside">Whether only its documentation holds the poster to one thread.</param>
    public SpareSlots NewSpares(int count, bool isOutside)
    {
        int[] indices = new int[count];
        for (int i = 0; i < count; i++)
            indices[i] = AddSlot();
        return new SpareSlots(indices, isOutside);
    }

    /// <summary>Posts a value.</summary>
    /// <returns>Its version.</returns>
    public int Store<TCopier>(TCopier value, SpareSlots spares, ref long latest)
        where TCopier : struct, ISlotCopier<TSlot>
    {
        bool isPlain = _isAlone && default(TSync).VolatileRead(ref _fencesDemanded) == 0;
        TSlot slot = Take(spares);
        if (_tries > 0)
            Spoil(slot, ref latest);
        value.CopyTo(slot);
        return isPlain ? PublishAlone(spares, ref latest) : Publish(slot, spares, ref latest);
    }

    /// <summary>Fetches the latest value.</summary>
    /// <returns>Its version.</returns>
    public int Load<TCopier>(ref TCopier value, ref long latest)
        where TCopier : struct, ISlotCopier<TSlot>
    {
        for (int i = 0; i < _tries; i++)
        {
            long word = default(TSync).VolatileRead(ref latest);
            TSlot slot = SlotAt(LatestSlot.IndexOf(word));
            value.CopyFrom(slot);
            default(TSync).LoadBarrier();
            int version = LatestSlot.VersionOf(word);
            if (default(TSync).VolatileRead(ref slot.Version) == version)
                return version;
        }

        return LoadPinned(ref value, ref latest);
    }

    /// <summary>The spare to write next: the first that no fetcher reads.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public TSlot Take(SpareSlots spares)
    {
        TSlot slot = SlotAt(spares.Next);
        return default(TSync).VolatileRead(ref slot.Pins) == 0 ? slot : TakeOther(spares);
    }

    private TSlot TakeOther(SpareSlots spares)
    {
        for (int i = 0; i < spares.Count; i++)
        {
            TSlot slot = SlotAt(spares.Next);
            if (default(TSync).VolatileRead(ref slot.Pins) == 0)
                return slot;
            spares.Skip();
        }

        spares.Add(AddSlot());
        return SlotAt(spares.Next);
    }

    /// <summary>Makes a written spare the latest.</summary>
    /// <returns>Its version.</returns>
    public static int Publish(TSlot slot, SpareSlots spares, ref long latest)
    {
        while (true)
        {
            long word = default(TSync).VolatileRead(ref latest);
            int version = NextVersion(LatestSlot.VersionOf(word));
            default(TSync).VolatileWrite(ref slot.Version, version);
            long next = LatestSlot.Join(version, spares.Next);
            if (default(TSync).CompareExchange(ref latest, next, word) != word)
                continue;
            spares.Replace(LatestSlot.IndexOf(word));
            return version;
        }
    }

    /// <summary>
    /// The latest slot, which no poster writes before <see cref="Unpin"/>. Looked for again only where a post has come
    /// in between: no more often than the version has grown since the first look.
    /// </summary>
    public TSlot Pin(ref long latest, out int version)
    {
        while (true)
        {
            long word = default(TSync).VolatileRead(ref latest);
            TSlot slot = SlotAt(LatestSlot.IndexOf(word));
            Add(ref slot.Pins, 1);
            if (default(TSync).VolatileRead(ref latest) == word)
            {
                version = LatestSlot.VersionOf(word);
                return slot;
            }

            Add(ref slot.Pins, -1);
        }
    }

    public static void Unpin(TSlot slot) => Add(ref slot.Pins, -1);

    private int LoadPinned<TCopier>(ref TCopier value, ref long latest)
        where TCopier : struct, ISlotCopier<TSlot>
    {
        if (_isAlone)
        {
            Add(ref _fencesDemanded, 1);
            default(TSync).FenceAllThreads();
        }

        TSlot slot = Pin(ref latest, out int version);
        value.CopyFrom(slot);
        Unpin(slot);
        if (_isAlone)
            Add(ref _fencesDemanded, -1);
        return version;
    }

    // Before a value is written where fetchers may read it optimistically: spoils what they read.
    private static void Spoil(TSlot slot, ref long latest)
    {
        int version = LatestSlot.VersionOf(default(TSync).VolatileRead(ref latest));
        default(TSync).VolatileWrite(ref slot.Version, NextVersion(version));
        default(TSync).StoreBarrier();
    }

    // By the only poster, where no fences are demanded.
    private static int PublishAlone(SpareSlots spares, ref long latest)
    {
        long replaced = default(TSync).VolatileRead(ref latest);
        int version = NextVersion(LatestSlot.VersionOf(replaced));   // as Spoil wrote it: there is no other poster
        default(TSync).VolatileWrite(ref latest, LatestSlot.Join(version, spares.Next));
        spares.Replace(LatestSlot.IndexOf(replaced));
        return version;
    }

    private TSlot SlotAt(int index) => Volatile.Read(ref _slots)[index];

    private static int NextVersion(int version) => unchecked(version + 1) is var next && next == 0 ? 1 : next;

    private static void Add(ref int location, int change)
    {
        int found;
        do
            found = default(TSync).VolatileRead(ref location);
        while (default(TSync).CompareExchange(ref location, found + change, found) != found);
    }

    // While wiring, and by posters all of whose spares are read at once.
    private int AddSlot()
    {
        TSlot added = _create();
        while (true)
        {
            TSlot[] slots = Volatile.Read(ref _slots);
            if (Interlocked.CompareExchange(ref _slots, [.. slots, added], slots) == slots)
                return slots.Length;
        }
    }
}
