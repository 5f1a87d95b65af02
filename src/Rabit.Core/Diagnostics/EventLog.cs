using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Core.Managers;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// Writes down what happens in a run in virtual time: who ran and why, who woke whom, what was posted, pushed and
/// popped, what went wrong, and the stop. Lines hold nothing of the machine, its culture or its runtime, so that two
/// logs of one seed can be compared to the byte.
/// </summary>
/// <remarks>
/// Called by the engine, by handlers of posts and by the log of the run; nothing of it exists in a run without an event
/// log. What a step did to queues is seen in their counters when it ends: that needs no hook in a push, and no kind of
/// push can be forgotten.
/// </remarks>
internal sealed class EventLog(TextWriter writer, RunClock clock, Action<Exception> fail)
{
    private const string Outside = "outside";

    // Guards all that follows, and the writer: code outside the run may post and wake from other threads.
    private readonly object _gate = new();
    private readonly EventLine _line = new();
    private readonly List<WatchedQueue> _queues = [];
    private readonly Dictionary<WakeUpCauses, string> _causes = [];
    private string? _actor;       // whose step is running, on the thread of the run
    private int _actorThread;
    private bool _hasFailed;

    /// <summary>An owner of handlers that is no manager, so that every post is reported to it.</summary>
    public EndpointOwner Owner { get; } = new("event log", isManager: false, wakeUp: null);

    /// <summary>Has the changes of a queue written, queues in the order of the calls.</summary>
    public void Watch(IMessageQueue queue)
    {
        lock (_gate)
            _queues.Add(new WatchedQueue(queue));
    }

    /// <summary>Writes what code outside the run did to queues, before the run continues.</summary>
    public void WriteOutsideChanges()
    {
        lock (_gate)
            WriteQueues(Outside);
    }

    /// <summary>From here to <see cref="Leave"/>, what this thread does is this activity's doing.</summary>
    public void Enter(Activity activity, string does)
    {
        lock (_gate)
        {
            SetActor(activity);
            Put(_line.Begin(clock.Now, activity.Name).Add(does));
        }
    }

    /// <summary>As <see cref="Enter"/>, for a step.</summary>
    public void EnterStep(Activity activity, ConsumedWakeUps wakes)
    {
        lock (_gate)
        {
            SetActor(activity);
            _line.Begin(clock.Now, activity.Name).Add("runs (").Add(TextOf(wakes.Causes));
            if (wakes.Count > 1)
                _line.Add("; ").Add(wakes.Count).Add(" wakes");
            _line.Add(")");
            if (activity.ModelledDuration > TimeSpan.Zero)
                _line.Add(", takes ").Add(activity.ModelledDuration);
            Put(_line);
        }
    }

    public void Leave()
    {
        lock (_gate)
        {
            WriteQueues(_actor!);
            _actor = null;
        }
    }

    /// <summary>
    /// A wake that ended a sleep. Those that merge with it are in the count of the step that follows.
    /// </summary>
    public void Wakes(Activity sleeper)
    {
        WakeUpCauses causes = CausesOf(sleeper.WakeUp);
        if (causes == WakeUpCauses.Start)
            return;
        lock (_gate)
            Put(_line.Begin(clock.Now, Actor).Add("wakes ").Add(sleeper.Name).Add(" (").Add(TextOf(causes)).Add(")"));
    }

    public void Posted(string message, MessageStamp stamp)
    {
        lock (_gate)
        {
            TimeSpan now = clock.Now;
            _line.Begin(now, Actor).Add("posts ").Add(message).Add(", version ").Add(stamp.Version);
            if (stamp.Time != now)
                _line.Add(", true at ").Add(stamp.Time);
            Put(_line);
        }
    }

    public void Write(string source, string text)
    {
        lock (_gate)
            Put(_line.Begin(clock.Now, source).Add(text));
    }

    /// <summary>The run is over.</summary>
    public void Close()
    {
        lock (_gate)
        {
            WriteQueues(Outside);
            if (_hasFailed)
                return;
            try
            {
                writer.Flush();
            }
            catch (Exception e)
            {
                // See Put.
                Fail(e);
            }
        }
    }

    // Only what this thread does is attributed to the activity whose step is running.
    private string Actor => _actor is not null && _actorThread == Environment.CurrentManagedThreadId ? _actor : Outside;

    private void SetActor(Activity activity)
    {
        WriteQueues(Outside);
        _actor = activity.Name;
        _actorThread = Environment.CurrentManagedThreadId;
    }

    private void WriteQueues(string actor)
    {
        foreach (WatchedQueue queue in _queues)
        {
            if (queue.TryWriteChange(_line, clock.Now, actor))
                Put(_line);
        }
    }

    private void Put(EventLine line)
    {
        if (_hasFailed)
            return;
        try
        {
            line.WriteTo(writer);
        }
        catch (Exception e)
        {
            // The disk is full, or whatever it is: half an event log proves nothing, so the run fails, and says why.
            Fail(e);
        }
    }

    private void Fail(Exception e)
    {
        _hasFailed = true;
        fail(new IOException("The event log could not be written: " + ExceptionText.MessageOf(e), e));
    }

    private static WakeUpCauses CausesOf(WakeUpEvent wakeUp)
    {
        var causes = WakeUpCauses.None;
        for (int cause = (int)WakeUpCauses.Start; cause <= (int)WakeUpCauses.Device; cause <<= 1)
        {
            if (wakeUp.Has(cause))
                causes |= (WakeUpCauses)cause;
        }

        return causes;
    }

    // Kept: the text of an enum is allocated each time.
    private string TextOf(WakeUpCauses causes)
    {
        if (!_causes.TryGetValue(causes, out string? text))
            _causes.Add(causes, text = causes.ToString());
        return text;
    }
}
