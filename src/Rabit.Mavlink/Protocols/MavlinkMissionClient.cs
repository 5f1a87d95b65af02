using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Uploads, downloads and clears missions, fences and rally points of one component (MAVLink guide, "Mission
/// Protocol"), one transfer after another, each with exactly one outcome. No I/O, no clock: frames in, frames out, time
/// as argument. One thread; allocates for a transfer longer than any before, nothing per frame.
/// </summary>
/// <remarks>
/// Items are sent as MISSION_ITEM_INT, also where the vehicle requests them with the old MISSION_REQUEST. On ArduPilot
/// item 0 of a mission is home: it is returned as the autopilot has it, and an upload that failed half way may have
/// changed what it had.
/// </remarks>
/// <example>
/// <code>
/// static void Upload(MavlinkMissionClient client, TimeSpan now)
/// {
///     var items = new MissionItemInt[2];
///     items[0] = new MissionItemInt { Command = MavCmd.NavTakeoff, Frame = MavFrame.GlobalRelativeAlt, Z = 30 };
///     items[1] = new MissionItemInt { Command = MavCmd.NavReturnToLaunch, Autocontinue = 1 };
///     client.TryStartUpload(MavMissionType.Mission, items, now);
/// }
///
/// // For every frame that arrives: client.Handle(frame, now). After that, and at client.NextDue at the latest:
/// static void Step(MavlinkMissionClient client, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (client.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     if (client.TryTakeOutcome(out MavlinkMissionOutcome outcome))
///         Console.WriteLine($"{outcome.Status}, {outcome.Items} items");
/// }
/// </code>
/// </example>
public sealed partial class MavlinkMissionClient
{
    private readonly MavlinkSender _sender;
    private readonly MavlinkAddress _own;
    private readonly MavlinkAddress _target;
    private readonly MavlinkMissionOptions _options;
    private Operation _operation;
    private MavMissionType _type;
    private MissionItemInt[] _items = [];
    private int _count;
    private MavlinkMissionOutcome _outcome;
    private bool _hasOutcome;

    // What is sent next, and when.
    private Step _step;
    private TimeSpan _due;
    private int _tries;
    private int _sent;

    // Of an upload: the item requested last, and the highest requested so far. Of a download: the item wanted.
    private int _seq;
    private int _highest;
    private TimeSpan _giveUpAt;
    private MavMissionResult? _result;

    private TimeSpan _lastSentAt = TimeSpan.MinValue;
    private TimeSpan _lastPlainAt = TimeSpan.MinValue;
    private MavMissionResult? _finalAck;
    private MavMissionType _finalAckType;
    private int _finalAckRepeats;
    private bool _isDownloadOver;

    /// <summary>Makes a client.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="target">Whose missions.</param>
    /// <param name="options">Time-outs and retries; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentException">The target is not one component.</exception>
    public MavlinkMissionClient(MavlinkSender sender, MavlinkAddress target, MavlinkMissionOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        if (target.SystemId == 0 || target.ComponentId == 0)
            throw new ArgumentException("A mission belongs to one component; 0 means all.", nameof(target));
        _own = new MavlinkAddress(sender.SystemId, sender.ComponentId);
        _target = target;
        _options = options ?? new MavlinkMissionOptions();
    }

    private enum Operation
    {
        None,
        Upload,
        Download,
        Clear,
    }

    private enum Step
    {
        Count,
        Item,
        List,
        Request,
        Clear,
    }

    /// <summary>Whether a transfer is under way, or its outcome not taken yet: no other can start.</summary>
    public bool IsBusy => _operation != Operation.None || _hasOutcome;

    /// <summary>How many items the transfer has; 0 while a download does not know it yet.</summary>
    public int Count => _count;

    /// <summary>How many items are done: received, or requested by the vehicle.</summary>
    public int ItemsDone => _operation == Operation.Upload ? _highest + 1 : _seq;

    /// <summary>
    /// What was downloaded last, until the next transfer begins; of a download that failed, the items received in
    /// order.
    /// </summary>
    public ReadOnlySpan<MissionItemInt> Items => _isDownloadOver ? _items.AsSpan(0, _seq) : default;

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for.
    /// </summary>
    public TimeSpan NextDue
        => _finalAck is not null ? TimeSpan.Zero : _operation == Operation.None ? TimeSpan.MaxValue : _due;

    /// <summary>Starts an upload. The items are copied; sequence numbers, target and type are filled in.</summary>
    /// <param name="type">Mission, fence or rally points.</param>
    /// <param name="items">At most 65535; none clears what the vehicle has.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    /// <exception cref="ArgumentException">Too many items.</exception>
    public bool TryStartUpload(MavMissionType type, ReadOnlySpan<MissionItemInt> items, TimeSpan now)
    {
        if (items.Length > ushort.MaxValue)
            throw new ArgumentException($"{items.Length} items; a transfer has 65535 at most.", nameof(items));
        if (!TryStart(Operation.Upload, Step.Count, type, now))
            return false;
        Reserve(items.Length);
        items.CopyTo(_items);
        for (int i = 0; i < items.Length; i++)
        {
            _items[i].Seq = (ushort)i;
            _items[i].MissionType = type;
            _items[i].TargetSystem = _target.SystemId;
            _items[i].TargetComponent = _target.ComponentId;
        }

        return true;
    }

    /// <summary>Starts a download.</summary>
    /// <param name="type">Mission, fence or rally points.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    public bool TryStartDownload(MavMissionType type, TimeSpan now)
        => TryStart(Operation.Download, Step.List, type, now);

    /// <summary>
    /// Starts to clear. A vehicle that does not clear all at once (ArduPilot does not know that type) is asked to clear
    /// the mission, the fence and the rally points one after the other, and where it knows no MISSION_CLEAR_ALL for a
    /// type, is sent one of no items.
    /// </summary>
    /// <param name="type">Mission, fence, rally points, or all of them.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    public bool TryStartClear(MavMissionType type, TimeSpan now) => TryStart(Operation.Clear, Step.Clear, type, now);

    /// <summary>
    /// Ends the transfer, with the outcome <see cref="MavlinkMissionStatus.Cancelled"/>, and notifies the vehicle.
    /// </summary>
    /// <param name="now">The time.</param>
    public void Cancel(TimeSpan now)
    {
        if (_operation != Operation.None)
            GiveUp(MavlinkMissionStatus.Cancelled, now);
    }

    /// <summary>Takes the outcome of the last transfer; it is returned once.</summary>
    /// <param name="outcome">The outcome.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeOutcome(out MavlinkMissionOutcome outcome)
    {
        outcome = _hasOutcome ? _outcome : default;
        bool had = _hasOutcome;
        _hasOutcome = false;
        return had;
    }

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (_finalAck is { } result)
        {
            _finalAck = null;
            frame = _sender.Create(new MissionAck
            {
                TargetSystem = _target.SystemId,
                TargetComponent = _target.ComponentId,
                Type = result,
                MissionType = _finalAckType,
            });
            _lastSentAt = now;
            return true;
        }

        if (_operation == Operation.None || now < _due)
            return false;
        if (_tries > _options.Retries || (_operation == Operation.Upload && _highest >= 0 && now >= _giveUpAt))
        {
            // INVALID_SEQUENCE to a copy of an item is no refusal, and what an upload has changed is not known.
            bool isRefused = _operation != Operation.Upload && _result is not null;
            GiveUp(isRefused ? MavlinkMissionStatus.Refused : MavlinkMissionStatus.Unknown, now);
            return TryTakeFrame(now, out frame);
        }

        frame = Next();
        _tries++;
        _sent++;
        _lastSentAt = now;
        if (_type == MavMissionType.Mission)
            _lastPlainAt = now;
        _due = now + (_step == Step.Request ? _options.ItemTimeout : _options.AnswerTimeout);
        return true;
    }

    private bool TryStart(Operation operation, Step step, MavMissionType type, TimeSpan now)
    {
        if (IsBusy)
            return false;
        _operation = operation;
        _step = step;
        _type = type;
        _count = _tries = _sent = _seq = 0;
        _highest = -1;
        _result = null;
        _isDownloadOver = false;
        BeginClearing();
        _due = _lastSentAt != TimeSpan.MinValue && now < _lastSentAt + _options.LateAnswerTime
            ? _lastSentAt + _options.LateAnswerTime
            : now;
        return true;
    }

    private MavlinkFrame Next() => _step switch
    {
        Step.Count => _sender.Create(new MissionCount
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            Count = (ushort)_count,
            MissionType = _type,
        }),
        // A request may be a late duplicate; what is sent again without a request is the item after the last one
        // received.
        Step.Item => _sender.Create(_items[_tries > 0 ? _highest : _seq]),
        Step.List =>
            _sender.Create(
                new MissionRequestList
                {
                    TargetSystem = _target.SystemId,
                    TargetComponent = _target.ComponentId,
                    MissionType = _type
                }),
        Step.Request => _sender.Create(new MissionRequestInt
        {
            TargetSystem = _target.SystemId,
            TargetComponent = _target.ComponentId,
            Seq = (ushort)_seq,
            MissionType = _type,
        }),
        _ =>
            _sender.Create(
                new MissionClearAll
                {
                    TargetSystem = _target.SystemId,
                    TargetComponent = _target.ComponentId,
                    MissionType = _type
                }),
    };

    private void Reserve(int count)
    {
        _count = count;
        if (_items.Length < count)
            _items = new MissionItemInt[count];
    }

    private void GiveUp(MavlinkMissionStatus status, TimeSpan now)
    {
        // The vehicle may be left waiting: both sides return to idle.
        if (_sent > 0 && _operation != Operation.Clear)
            QueueFinalAck(MavMissionResult.OperationCancelled);
        End(status, 0, now);
    }

    private void QueueFinalAck(MavMissionResult result)
    {
        _finalAck = result;
        _finalAckType = _type;
    }

    private void End(MavlinkMissionStatus status, uint opaqueId, TimeSpan now)
    {
        if (_operation == Operation.Clear && GoesOnClearing(ref status, now))
            return;
        _outcome = new MavlinkMissionOutcome(status, _result, ItemsDone, opaqueId, _sent, now);
        _isDownloadOver = _operation == Operation.Download;
        _finalAckRepeats = 0;
        _operation = Operation.None;
        _hasOutcome = true;
    }
}
