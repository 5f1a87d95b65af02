using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The targets that we found and that another vehicle is to validate. We alone decide who does, and repeat the state of
/// each task: an award that was lost is repeated, one whose vehicle is silent is withdrawn and given to another one by
/// an award with a higher number, and a vehicle that was out of reach meanwhile drops the older one when it receives
/// that. Time-free but for the time it is given; one thread.
/// </summary>
internal sealed class ValidationFinder(ushort session, IValidationSender sender, Action<string> log)
{
    /// <summary>More targets are not validated, and counted.</summary>
    public const int MaxTasks = 64;

    // At once; the others wait, so that the radio is not filled.
    private const int MaxActive = 3;

    // After a partition a vehicle whose award was withdrawn drops it within 3 s, also where 40 % is lost.
    private static readonly TimeSpan AwardedRepeat = TimeSpan.OfSeconds(0.5);

    private static readonly TimeSpan Repeat = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan BidTime = TimeSpan.FromSeconds(2);

    // None can now: who can later says so by itself.
    private static readonly TimeSpan DeclinedRepeat = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan ClosedRepeats = TimeSpan.FromSeconds(4);

    private readonly List<OwnTask> _tasks = [];

    /// <summary>Bids that were refused: of no task of ours, or not of the vehicle that was awarded.</summary>
    public long Refused { get; private set; }

    /// <summary>Targets that were not announced, since there were too many.</summary>
    public long LeftOut { get; private set; }

    public IEnumerable<ValidationTask> Tasks => _tasks.Select(t => t.Task);

    /// <summary>Whether one of them is not closed.</summary>
    public bool IsPending => _tasks.Any(t => t.Task.State != ValidationState.Closed);

    /// <summary>The task of a track; null where it has none.</summary>
    public ValidationTask? Find(int trackId)
    {
        foreach (OwnTask task in _tasks)
        {
            if (task.TrackId == trackId)
                return task.Task;
        }

        return null;
    }

    /// <summary>Announces a target; once for each track.</summary>
    public void Announce(int trackId, ValidationTask target)
    {
        if (Find(trackId) is not null)
            return;
        if (_tasks.Count >= MaxTasks)
        {
            LeftOut++;
            return;
        }

        target.Session = session;
        target.Number = (ushort)(_tasks.Count + 1);
        target.State = ValidationState.Open;
        (target.Award, target.Validator, target.Result) = (0, 0, ValidationResult.Unknown);
        _tasks.Add(new OwnTask(trackId, target));
    }

    /// <summary>Leaves a target to the task of another vehicle.</summary>
    public void Withdraw(int trackId, TimeSpan now)
    {
        OwnTask? task = _tasks.Find(t => t.TrackId == trackId && t.Task.State == ValidationState.Open);
        task?.Close(ValidationResult.Unknown, now);
    }

    /// <summary>
    /// The operator has rejected a target: its task ends, also one that has another result. Where it has none there
    /// will be none, of another finder neither: it is announced as what it is.
    /// </summary>
    public void Reject(int trackId, ValidationTask target, byte ownSystemId, TimeSpan now)
    {
        Announce(trackId, target);
        if (_tasks.Find(t => t.TrackId == trackId) is not { } task
            || (task.Task with { Finder = ownSystemId }).IsRejectedByOperator)
            return;
        log($"track {MissionNumbers.Of(trackId)} is rejected by the operator: it needs no validation");
        task.Reject(ownSystemId, now);
    }

    /// <summary>Sends the state of a task once more.</summary>
    public void SendSoon(ushort number, TimeSpan now)
    {
        if (_tasks.Find(t => t.Task.Number == number) is { } task)
            (task.SendAt, task.IsAsked) = (now, true);
    }

    public void Receive(byte source, in ValidationBid bid, TimeSpan now)
    {
        ushort number = bid.Number;
        OwnTask? task = bid.Session == session ? _tasks.Find(t => t.Task.Number == number) : null;
        if (task is null)
        {
            Refused++;
            return;
        }

        bool isOfValidator = task.Task.State == ValidationState.Awarded && source == task.Task.Validator
            && bid.Award == task.Task.Award;
        if (task.Task.State == ValidationState.Open && bid.State <= ValidationBidState.Declined)
            task.Bids[source] = bid.State == ValidationBidState.Offered ? bid.Seconds : double.PositiveInfinity;
        else if (isOfValidator)
            TakeAnswer(task, bid, now);
        else if (bid.State >= ValidationBidState.Underway)
            (task.SendAt, task.IsAsked) = (now, true); // it does not know yet that it is not its any more
    }

    /// <summary>In each tick.</summary>
    /// <param name="present">The system ids of the vehicles that can validate.</param>
    /// <param name="now">The time.</param>
    public void Update(IReadOnlyCollection<byte> present, TimeSpan now)
    {
        int active = _tasks.Count(t => t.Task.State == ValidationState.Awarded);
        foreach (OwnTask task in _tasks)
        {
            bool isPut = task.IsDeclined && now < task.SendAt && task.Bids.Count == 0;
            if (task.Task.State == ValidationState.Open && !isPut && (present.Count == 0 || active++ >= MaxActive))
            {
                task.BidsSince = null;
                continue;
            }

            Update(task, present, now);
            bool isQuiet = task.Task.State == ValidationState.Closed && now > task.QuietFrom && !task.IsAsked;
            if (now < task.SendAt || isQuiet)
                continue;
            sender.Send(task.Task);
            (task.IsAsked, task.IsDeclined) = (false, false);
            task.SendAt = now + (task.Task.State == ValidationState.Awarded ? AwardedRepeat : Repeat);
        }
    }

    private void TakeAnswer(OwnTask task, in ValidationBid bid, TimeSpan now)
    {
        task.LastAnswer = now;
        if (bid.State == ValidationBidState.Declined)
            Reopen(task, "declines");
        if (bid.State != ValidationBidState.Finished)
            return;
        log($"vehicle {MissionNumbers.Of(task.Task.Validator)} has validated track {MissionNumbers.Of(task.TrackId)}: "
            + bid.Result.ToString().ToLowerInvariant());
        task.Close(bid.Result, now);
    }

    private void Update(OwnTask task, IReadOnlyCollection<byte> present, TimeSpan now)
    {
        switch (task.Task.State)
        {
            case ValidationState.Open:
                task.BidsSince ??= now;
                bool haveAllAnswered = present.All(task.Bids.ContainsKey);
                if (haveAllAnswered || now - task.BidsSince.Value >= BidTime)
                    Award(task, present, now);
                break;
            case ValidationState.Awarded when now - task.LastAnswer > MaxSilence:
                Reopen(task, "does not answer");
                break;
            default:
                break;
        }
    }

    private void Award(OwnTask task, IReadOnlyCollection<byte> present, TimeSpan now)
    {
        byte best = 0;
        double least = double.PositiveInfinity;
        foreach (KeyValuePair<byte, double> bid in task.Bids.OrderBy(b => b.Key))
        {
            if (present.Contains(bid.Key) && bid.Value < least)
                (best, least) = (bid.Key, bid.Value);
        }

        // Who declined may be able to later.
        if (best == 0 && task.Bids.Count > 0)
            (task.IsDeclined, task.SendAt) = (true, now + DeclinedRepeat);
        task.Bids.Clear();
        task.BidsSince = now;
        if (best == 0)
            return;
        task.Award(best, now);
        log($"vehicle {MissionNumbers.Of(best)} is to validate track {MissionNumbers.Of(task.TrackId)}, in "
            + $"{MissionNumbers.Of(least)} s");
    }

    private void Reopen(OwnTask task, string why)
    {
        log($"vehicle {MissionNumbers.Of(task.Task.Validator)} {why}: another one is to validate track "
            + MissionNumbers.Of(task.TrackId));
        task.Reopen();
    }

    private sealed class OwnTask(int trackId, ValidationTask task)
    {
        private ValidationTask _task = task;

        public int TrackId { get; } = trackId;

        public ValidationTask Task => _task;

        /// <summary>The seconds of those who answered; infinite for those who declined.</summary>
        public Dictionary<byte, double> Bids { get; } = [];

        public TimeSpan? BidsSince { get; set; }

        /// <summary>Whether all who answered declined, when it was announced last.</summary>
        public bool IsDeclined { get; set; }

        public TimeSpan LastAnswer { get; set; }

        public TimeSpan SendAt { get; set; }

        public TimeSpan QuietFrom { get; private set; }

        /// <summary>Whether a vehicle asked for it after it was closed.</summary>
        public bool IsAsked { get; set; }

        public void Award(byte validator, TimeSpan now)
        {
            _task.State = ValidationState.Awarded;
            _task.Validator = validator;
            _task.Award++;
            (LastAnswer, SendAt) = (now, now);
        }

        public void Reopen()
        {
            _task.State = ValidationState.Open;
            _task.Validator = 0;
            BidsSince = null;
            SendAt = TimeSpan.Zero;
        }

        public void Reject(byte finder, TimeSpan now)
        {
            _task.Validator = finder;
            Close(ValidationResult.Rejected, now);
        }

        public void Close(ValidationResult result, TimeSpan now)
        {
            _task.State = ValidationState.Closed;
            _task.Result = result;
            (SendAt, QuietFrom) = (now, now + ClosedRepeats);
        }
    }
}
