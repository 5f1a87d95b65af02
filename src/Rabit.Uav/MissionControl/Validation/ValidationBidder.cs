using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The targets of other vehicles that we may validate. Each state of a task that comes in is answered; what was awarded
/// to us is a job until it is done or given to another one. Time-free but for the time it is given; one thread.
/// </summary>
internal sealed class ValidationBidder(IValidationSender sender)
{
    /// <summary>More tasks of others are not known, and counted.</summary>
    public const int MaxTasks = 256;

    private static readonly TimeSpan Repeat = TimeSpan.FromSeconds(1);

    // A finder that is not received for so long after the end does not get the result.
    private static readonly TimeSpan MaxResultTime = TimeSpan.FromMinutes(2);

    private readonly SortedDictionary<(byte Finder, ushort Session, ushort Number), ValidationTask> _tasks = [];
    private readonly List<Job> _jobs = [];

    /// <summary>States that were refused: older ones, or of more tasks than are kept.</summary>
    public long Refused { get; private set; }

    public IEnumerable<ValidationTask> Tasks => _tasks.Values;

    /// <summary>What is to be flown, in the order in which it was awarded.</summary>
    public IEnumerable<ValidationTask> Jobs
        => _jobs.Where(j => j.State == ValidationBidState.Underway).Select(j => _tasks[j.Key]);

    /// <summary>Whether a task is ours to fly.</summary>
    public bool IsOurs(in ValidationTask task)
    {
        (byte, ushort, ushort) key = KeyOf(task);
        return _jobs.Exists(j => j.Key == key && j.State == ValidationBidState.Underway);
    }

    /// <summary>Takes the state of a task.</summary>
    /// <param name="task">As its finder sent it.</param>
    /// <param name="ownSystemId">Ours.</param>
    /// <param name="secondsTo">After what time we would be there; null where we cannot.</param>
    /// <param name="now">The time.</param>
    public void Receive(in ValidationTask task, byte ownSystemId, Func<ValidationTask, double?> secondsTo, TimeSpan now)
    {
        (byte, ushort, ushort) key = KeyOf(task);
        bool isKnown = _tasks.TryGetValue(key, out ValidationTask known);
        bool isOlder = isKnown && (task.Award < known.Award
            || (task.Award == known.Award && task.State == ValidationState.Awarded && known.State != task.State)
            || known.State == ValidationState.Closed);
        bool isRejected = known.IsRejectedByOperator && !task.IsRejectedByOperator;
        if (task.Finder == ownSystemId || (!isKnown && _tasks.Count >= MaxTasks) || isRejected
            || (isOlder && task.State != ValidationState.Closed))
        {
            Refused++;
            return;
        }

        _tasks[key] = task;
        Job? job = _jobs.Find(j => j.Key == key);
        bool isOurs = task.State == ValidationState.Awarded && task.Validator == ownSystemId;
        if (job is not null && (!isOurs || job.Award != task.Award))
            _jobs.Remove(job);
        if (isOurs && !_jobs.Exists(j => j.Key == key))
            _jobs.Add(new Job(key, task.Award));
        if (task.State == ValidationState.Open)
            Bid(task, secondsTo(task));
        else if (isOurs)
            _jobs.Find(j => j.Key == key)!.SendAt = now;
    }

    /// <summary>We can fly now, where we could not before: bids for all that is open, unasked.</summary>
    public void BidForOpen(Func<ValidationTask, double?> secondsTo)
    {
        foreach (ValidationTask task in _tasks.Values.Where(t => t.State == ValidationState.Open))
        {
            if (secondsTo(task) is { } seconds)
                Bid(task, seconds);
        }
    }

    /// <summary>A job is done.</summary>
    public void Finish(in ValidationTask task, ValidationResult result, TimeSpan now)
    {
        (byte, ushort, ushort) key = KeyOf(task);
        if (_jobs.Find(j => j.Key == key) is not { } job)
            return;
        (job.State, job.Result) = (ValidationBidState.Finished, result);
        (job.SendAt, job.Until) = (now, now + MaxResultTime);
    }

    /// <summary>We cannot fly the jobs: they are for others.</summary>
    public void DeclineAll(TimeSpan now)
    {
        foreach (Job job in _jobs.Where(j => j.State == ValidationBidState.Underway))
        {
            job.State = ValidationBidState.Declined;
            (job.SendAt, job.Until) = (now, now + MaxResultTime);
        }
    }

    /// <summary>In each tick: repeats what the finders of our jobs have not answered.</summary>
    public void Update(TimeSpan now)
    {
        _jobs.RemoveAll(j => j.State != ValidationBidState.Underway && now > j.Until);
        foreach (Job job in _jobs)
        {
            if (now < job.SendAt)
                continue;
            job.SendAt = now + Repeat;
            sender.Send(
                new ValidationBid
                {
                    Session = job.Key.Session,
                    Number = job.Key.Number,
                    Award = job.Award,
                    State = job.State,
                    Result = job.Result,
                },
                job.Key.Finder);
        }
    }

    private void Bid(in ValidationTask task, double? seconds) => sender.Send(
        new ValidationBid
        {
            Session = task.Session,
            Number = task.Number,
            Award = task.Award,
            State = seconds is null ? ValidationBidState.Declined : ValidationBidState.Offered,
            Seconds = seconds ?? 0,
        },
        task.Finder);

    /// <summary>What a task is known by.</summary>
    public static (byte Finder, ushort Session, ushort Number) KeyOf(in ValidationTask task)
        => (task.Finder, task.Session, task.Number);

    private sealed class Job((byte Finder, ushort Session, ushort Number) key, ushort award)
    {
        public (byte Finder, ushort Session, ushort Number) Key { get; } = key;

        public ushort Award { get; } = award;

        public ValidationBidState State { get; set; } = ValidationBidState.Underway;

        public ValidationResult Result { get; set; }

        public TimeSpan SendAt { get; set; }

        public TimeSpan Until { get; set; } = TimeSpan.MaxValue;
    }
}
