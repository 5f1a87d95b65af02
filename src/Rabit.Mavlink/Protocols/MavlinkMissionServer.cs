using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Keeps the mission, the fence and the rally points of one component (MAVLink guide, "Mission Protocol"): uploads,
/// downloads, clears, the current item. No I/O, no clock: frames in, frames out, time as argument. One thread;
/// allocates for a transfer longer than any before, nothing per frame.
/// </summary>
/// <remarks>
/// What is stored changes only when the last item of an upload has arrived and all were accepted: an upload that is
/// refused, given up or cancelled leaves it as it was. One upload at a time: a second station is answered DENIED until
/// it is over. A download that is overtaken by a change is answered OPERATION_CANCELLED, so that it never mixes the old
/// items with the new.
/// </remarks>
/// <example>
/// <code>
/// var server = new MavlinkMissionServer(
///     new MavlinkSender(1, 191), options: new MavlinkMissionServerOptions { HasMission = false, HasRally = false });
///
/// // For every frame that arrives: server.Handle(frame, now). After that, and at server.NextDue at the latest:
/// static void Step(MavlinkMissionServer server, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (server.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
///     while (server.TryTakeChange(out MavlinkMissionChange change))
///         Console.WriteLine($"{change.Type}: {server.Items(change.Type).Length} items from {change.Source}");
/// }
/// </code>
/// </example>
public sealed partial class MavlinkMissionServer
{
    private const int TypeCount = 3;

    private readonly MavlinkSender _sender;
    private readonly IMavlinkMissionRules? _rules;
    private readonly MavlinkMissionServerOptions _options;
    private readonly StoredMissionItems[] _plans = [new(), new(), new()];
    private readonly MissionReply[] _replies;
    private int _firstReply;
    private int _replyCount;
    private int? _wantedCurrent;

    /// <summary>Makes a server without any items.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures; it is who is asked.</param>
    /// <param name="rules">What it takes; null: everything that fits.</param>
    /// <param name="options">What it has, and its times; null for the defaults.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number or time is out of range.</exception>
    public MavlinkMissionServer(
        MavlinkSender sender, IMavlinkMissionRules? rules = null, MavlinkMissionServerOptions? options = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _rules = rules;
        _options = options ?? new MavlinkMissionServerOptions();
        if (_options.MaxItems is < 0 or > ushort.MaxValue)
            throw new ArgumentOutOfRangeException(nameof(options), _options.MaxItems, "0 to 65535 items.");
        if (_options.RequestInterval <= TimeSpan.Zero || _options.Timeout <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(
                nameof(options), _options.RequestInterval, "The request interval and the timeout are above 0.");
        if (_options.Capacity < 1)
            throw new ArgumentOutOfRangeException(nameof(options), _options.Capacity, "The capacity is at min 1.");
        _replies = new MissionReply[_options.Capacity];
    }

    /// <summary>The current item of the mission.</summary>
    public int Current { get; private set; }

    /// <summary>The state of the mission, for MISSION_CURRENT; set it before <see cref="ReportCurrent"/>.</summary>
    public MissionState State { get; set; }

    /// <summary>Whether an upload is under way.</summary>
    public bool IsUploading => _uploader is not null;

    /// <summary>Who uploads; null where no upload is under way.</summary>
    public MavlinkAddress? Uploader => _uploader;

    /// <summary>
    /// Whether an upload is complete and waits for <see cref="Decide"/>; only with
    /// <see cref="MavlinkMissionServerOptions.DecidesLater"/>.
    /// </summary>
    public bool IsDecisionAwaited => _uploader is not null && _uploadCount > 0 && _received == _uploadCount;

    /// <summary>The items that a decision is awaited for; none where none is.</summary>
    public ReadOnlySpan<MissionItemInt> AwaitedItems
        => IsDecisionAwaited ? PlanOf(_uploadType).Incoming(_uploadCount) : default;

    /// <summary>Uploads, clears and items that were refused.</summary>
    public long Refusals { get; private set; }

    /// <summary>Uploads that ended without their last item: given up, or cancelled by the station.</summary>
    public long Aborts { get; private set; }

    /// <summary>Items that no upload was waiting for: copies and late ones.</summary>
    public long StrayItems { get; private set; }

    /// <summary>Answers that were not sent, since too many were waiting.</summary>
    public long Dropped { get; private set; }

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while there is nothing to
    /// wait for. A time in the past means at once.
    /// </summary>
    public TimeSpan NextDue => _replyCount > 0 ? TimeSpan.Zero : IsUploading ? _requestDue : TimeSpan.MaxValue;

    /// <summary>What is stored.</summary>
    /// <param name="type">Mission, fence or rally points.</param>
    /// <returns>The items, until the next change.</returns>
    /// <exception cref="ArgumentOutOfRangeException">None of the three.</exception>
    public ReadOnlySpan<MissionItemInt> Items(MavMissionType type) => PlanOf(type).Items;

    /// <summary>The id of what is stored; 0 where nothing is.</summary>
    /// <param name="type">Mission, fence or rally points.</param>
    /// <returns>The id.</returns>
    /// <exception cref="ArgumentOutOfRangeException">None of the three.</exception>
    public uint OpaqueId(MavMissionType type) => PlanOf(type).Id;

    /// <summary>
    /// Stores items from this side: those of before a reboot, for example. Numbers and type are filled in.
    /// </summary>
    /// <param name="type">Mission, fence or rally points.</param>
    /// <param name="items">The items, copied.</param>
    /// <exception cref="ArgumentException">Too many items.</exception>
    /// <exception cref="ArgumentOutOfRangeException">None of the three types.</exception>
    public void Store(MavMissionType type, ReadOnlySpan<MissionItemInt> items)
    {
        if (items.Length > _options.MaxItems)
            throw new ArgumentException($"{items.Length} items; {_options.MaxItems} fit.", nameof(items));
        PlanOf(type).Store(type, items);
        if (type == MavMissionType.Mission)
            Current = 0;
    }

    /// <summary>Takes the next change that was made by a station. Call it until there is none.</summary>
    /// <param name="change">The change; where several were made of one type, the last.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeChange(out MavlinkMissionChange change)
    {
        foreach (StoredMissionItems plan in _plans)
        {
            if (plan.Change is not { } found)
                continue;
            change = found;
            plan.Change = null;
            return true;
        }

        change = default;
        return false;
    }

    /// <summary>
    /// Takes the item that a station made the current one by MISSION_SET_CURRENT; each is returned once.
    /// </summary>
    /// <param name="sequence">Its number.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeSetCurrent(out int sequence)
    {
        sequence = _wantedCurrent ?? 0;
        bool had = _wantedCurrent is not null;
        _wantedCurrent = null;
        return had;
    }

    /// <summary>
    /// Makes an item the current one, and sends MISSION_CURRENT: for MAV_CMD_DO_SET_MISSION_CURRENT too.
    /// </summary>
    /// <param name="sequence">Its number.</param>
    /// <returns>Whether there is such an item.</returns>
    public bool TrySetCurrent(int sequence)
    {
        if (sequence < 0 || sequence >= _plans[0].Count)
            return false;
        Current = sequence;
        ReportCurrent();
        return true;
    }

    /// <summary>Sends MISSION_CURRENT; an autopilot does so once a second.</summary>
    public void ReportCurrent() => Enqueue(new MissionReply { Is = MissionReply.Kind.Current });

    /// <summary>Sends MISSION_ITEM_REACHED.</summary>
    /// <param name="sequence">Of which item.</param>
    public void ReportReached(int sequence)
        => Enqueue(new MissionReply { Is = MissionReply.Kind.Reached, Sequence = sequence });

    /// <summary>Takes the next frame to send. Call it until there is none.</summary>
    /// <param name="now">The time.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        if (_replyCount == 0)
            StepUpload(now);
        if (_replyCount > 0)
        {
            frame = Create(_replies[_firstReply]);
            _firstReply = (_firstReply + 1) % _replies.Length;
            _replyCount--;
            return true;
        }

        frame = default;
        if (!IsUploading || now < _requestDue)
            return false;
        _requestDue = now + (IsDecisionAwaited ? KeepAliveInterval : _options.RequestInterval);
        frame = Request();
        return true;
    }

    private StoredMissionItems PlanOf(MavMissionType type) => (uint)type < TypeCount
        ? _plans[(int)type]
        : throw new ArgumentOutOfRangeException(nameof(type), type, "Mission, fence or rally points.");

    private uint IdOf(MavMissionType type) => _options.SendsIds && (uint)type < TypeCount ? _plans[(int)type].Id : 0;
}
