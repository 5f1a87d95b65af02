using System;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;

namespace Rabit.Core.Messaging;

/// <summary>The hidden global copy that joins the local copies of a message.</summary>
/// <remarks>
/// The copy goes under a lock, since a value of any size must never be torn, on any processor, and neither poster nor
/// fetcher may be starved. Only the version is read without it: a fetch of an unchanged message is one volatile read.
/// It is 32 bits wide, because wider reads are not atomic on 32-bit boards.
/// </remarks>
internal sealed class SharedMessage<T>
{
    private readonly object _gate = new();
    private readonly T _initial;
    private readonly RabitLog _log;
    private T _value;                   // under _gate
    private TimeSpan _time;             // under _gate
    private int _version;               // written under _gate, read by all; 0: nothing posted yet
    private PostTarget[] _targets = []; // replaced whole under _gate, read by posters

    public SharedMessage(string name, T initial, RunClock clock, RabitLog log)
    {
        Name = name;
        Clock = clock;
        _initial = initial;
        _value = initial;
        _log = log;
    }

    public string Name { get; }

    public RunClock Clock { get; }

    public int Version => Volatile.Read(ref _version);

    public LocalCopy<T> CreateCopy() => new() { Value = _initial };

    public void AddTarget(PostTarget target)
    {
        lock (_gate)
        {
            var targets = new PostTarget[_targets.Length + 1];
            Array.Copy(_targets, targets, _targets.Length);
            targets[_targets.Length] = target;
            Volatile.Write(ref _targets, targets);
        }
    }

    public void Post(LocalCopy<T> copy, EndOwner poster, TimeSpan time)
    {
        int version;
        lock (_gate)
        {
            _value = copy.Value;
            _time = time;
            version = After(_version);
            Volatile.Write(ref _version, version);
        }

        copy.CoveredPosts += PostsBetween(copy.SeenVersion, version) - 1;
        copy.SeenVersion = version;
        copy.Stamp = new MessageStamp(version, time);

        foreach (PostTarget target in Volatile.Read(ref _targets))
        {
            // One's own post is not news to oneself.
            if (target.Owner != poster)
                Notify(target, copy.Stamp);
        }
    }

    /// <summary>Copies the global to a local copy.</summary>
    /// <returns>How many posts the owner had not seen, the fetched one included.</returns>
    public int Fetch(LocalCopy<T> copy)
    {
        int version;
        lock (_gate)
        {
            copy.Value = _value;
            copy.Stamp = new MessageStamp(_version, _time);
            version = _version;
        }

        int news = PostsBetween(copy.SeenVersion, version);
        copy.SeenVersion = version;
        if (news == 0)
            return 0;
        news += copy.CoveredPosts;
        copy.CoveredPosts = 0;
        return news;
    }

    private void Notify(PostTarget target, MessageStamp stamp)
    {
        target.WakeUp?.Wake(WakeUpCauses.Post);
        if (target.Handler is null)
            return;
        try
        {
            target.Handler(stamp);
        }
        catch (Exception e)
        {
            // A handler is somebody else's code on the poster's thread: it may not harm the poster.
            _log.Write(RabitLogKind.Fault, target.Owner.Name, $"the post handler of message '{Name}' threw {e.GetType().Name}: {e.Message}", e);
        }
    }

    // Zero is kept for "nothing posted yet", so the counter jumps over it when it wraps around.
    private static int After(int version) => unchecked(version + 1) == 0 ? 1 : unchecked(version + 1);

    private static int PostsBetween(int seen, int version)
    {
        int posts = unchecked(version - seen);
        return seen < 0 && version > 0 ? posts - 1 : posts;
    }
}
