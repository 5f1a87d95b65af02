using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.Locks;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>The global copy of a message whose class copies itself.</summary>
/// <remarks>
/// The copy method is the user's: it may take long, and it may throw half-way. So it never runs on an instance that
/// another thread may read. A post copies into the spare instance and then exchanges it for the latest; a fetch does
/// the same with the fetcher's own pair. A copy that failed leaves every copy with its whole previous value. All of it
/// is under a lock: code that knows nothing of threads may not meet an instance that is changing. Nothing is allocated
/// after wiring.
/// </remarks>
internal sealed class SharedObject<T> : SharedMessage<T>
{
    private readonly EndpointLock _gate;
    private readonly T _initial;
    private T _latest;        // both under _gate, and what they refer to
    private T _spare;
    private TimeSpan _time;   // under _gate
    private bool _isCopying;  // under _gate; seen only by a copy method that returns to its own message

    public SharedObject(MessagePlace place, T initial)
        : base(place, firstVersion: 0)
    {
        _gate = new EndpointLock(place.InheritsPriority);
        _initial = CloneOf(initial);
        _latest = CloneOf(initial);
        _spare = CloneOf(initial);
    }

    public override LocalCopy<T> CreateCopy()
    {
        using (_gate.Enter())
            return new LocalCopy<T>(CloneOf(_initial)) { Spare = CloneOf(_initial) };
    }

    public override MessageStamp ReadStamp()
    {
        using (_gate.Enter())
            return new MessageStamp(Version, _time);
    }

    public override void Assign(LocalCopy<T> copy, in T value)
    {
        if (ReferenceEquals(value, copy.Value))
            return;
        using (_gate.Enter())
        {
            Copy(value, copy.Spare, "posted");
            (copy.Value, copy.Spare) = (copy.Spare, copy.Value);
        }
    }

    protected override int Store(LocalCopy<T> copy, TimeSpan time)
    {
        using (_gate.Enter())
        {
            Copy(copy.Value, _spare, "posted");
            (_latest, _spare) = (_spare, _latest);
            _time = time;
            int version = NextVersion();
            Announce(version);
            return version;
        }
    }

    protected override int Load(LocalCopy<T> copy)
    {
        using (_gate.Enter())
        {
            Copy(_latest, copy.Spare, "fetched");
            (copy.Value, copy.Spare) = (copy.Spare, copy.Value);
            copy.Time = _time;
            return Version;
        }
    }

    private static T CloneOf(T value) => ((ISelfCopying<T>)value!).Clone();

    private void Copy(T from, T to, string verb)
    {
        if (_isCopying)
            throw new InvalidOperationException(
                $"{Type}.{nameof(ISelfCopying<>.CopyTo)} uses message '{Name}', which it is copying.");
        if (from is null || to is null)
            throw new InvalidOperationException($"Message '{Name}' cannot be {verb}: its value is null.");
        _isCopying = true;
        try
        {
            ((ISelfCopying<T>)from).CopyTo(to);
        }
        catch (Exception e)
        {
            // Thrown to the caller that posts or fetches, with the names that the user's exception lacks.
            throw new InvalidOperationException(
                $"Message '{Name}' could not be {verb}: {Type}.{nameof(ISelfCopying<>.CopyTo)} threw "
                    + ExceptionText.Describe(e), e);
        }
        finally
        {
            _isCopying = false;
        }
    }

    private static string Type => TypeNames.Of(typeof(T));
}
