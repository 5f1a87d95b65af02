using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Messages;

/// <summary>The global copy of a struct, or of the reference to an immutable object, without a lock.</summary>
/// <remarks>
/// How no torn read comes about: <see cref="SlotPool{TSlot, TSync}"/>. A fetch reads optimistically a few times; where
/// posts come all the way around each time it pins the slot. A copy that is thrown away does no harm even if it holds
/// references: the runtime copies each reference in one piece, so each was posted, though they may not belong together;
/// and it lies in the fetcher's own copy, which is not read before a whole one has replaced it.
/// <para>
/// netstandard2.0 has neither barriers that are cheap enough nor a fence for all threads, so that there every fetch
/// pins, and every post is made as one of several.
/// </para>
/// <para>Measured gain over a lock: decisions 0010 and 0060.</para>
/// </remarks>
internal sealed class SharedValue<T> : SharedMessage<T>
{
    private readonly SlotPool<ValueSlot<T>, SyncPoints> _pool;
    private readonly T _initial;

    /// <param name="place">Name, clock, log.</param>
    /// <param name="initial">The value before the first post.</param>
    /// <param name="isAlone">Whether there is one poster, which posts on one thread at a time.</param>
    /// <param name="version">The version to begin with; other than 0 for tests of the wrap-around.</param>
    /// <param name="tries">
    /// How often a fetch tries before it pins; 0 where every fetch does. Other than the default for tests.
    /// </param>
    public SharedValue(MessagePlace place, T initial, bool isAlone, int version = 0, int tries = OptimisticRead.Tries)
        : base(place, version)
    {
        _initial = initial;
        _pool = new SlotPool<ValueSlot<T>, SyncPoints>(
            new ValueSlot<T> { Version = version, Value = initial }, static () => new ValueSlot<T>(), tries,
            isAlone && OptimisticRead.Tries > 0);
    }

    public override LocalCopy<T> CreateCopy() => new(_initial);

    public override MessageStamp ReadStamp()
    {
        var time = default(TimeCopier<T>);
        int version = _pool.Load(ref time, ref Latest.Word);
        return new MessageStamp(version, time.Time);
    }

    protected override SpareSlots NewSpares(bool isOutside) => _pool.NewSpares(OptimisticRead.Spares, isOutside);

    protected override int Store(LocalCopy<T> copy, SpareSlots spares, TimeSpan time)
        => _pool.Store(new ValueCopier<T>(copy, time), spares, ref Latest.Word);

    protected override int Load(LocalCopy<T> copy)
    {
        var copier = new ValueCopier<T>(copy);
        return _pool.Load(ref copier, ref Latest.Word);
    }
}
