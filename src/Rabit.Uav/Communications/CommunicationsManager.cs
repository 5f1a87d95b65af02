using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Links;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// The post office between aircraft and ground: it owns the links, delivers frames that are for us to Autopilot
/// Interface and to subscriptions, forwards the others unchanged by MAVLink's address rules, and sends the frames of
/// the other managers. It reads addresses, never meaning, but for which link a ground station's heartbeats come over.
/// It reports our position and the targets to ground and others, and carries typed messages between vehicles.
/// </summary>
public sealed partial class CommunicationsManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "communications";

    private const int OutgoingCapacity = 256;
    private static readonly TimeSpan IdleDelay = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan StatusPeriod = TimeSpan.FromMilliseconds(500);

    private readonly CommunicationsOptions _options;
    private readonly MavlinkRouter _router = new();
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly QueueSender<LinkFrame> _autopilot;
    private readonly QueueReceiver<OutgoingFrame> _outgoing;
    private readonly List<LinkPort> _ports = [];
    private readonly long[] _droppedIn;
    private readonly FrameStatistics _own;
    private long _expired;
    private TimeSpan _nextStatus;
    private readonly DropReport _ownDrops = new();

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Its links; checked and read now.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public CommunicationsManager(CommunicationsOptions options)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).Validate(nameof(options));
        _router.ForwardsUnknownMessages = _options.ForwardsUnknownMessages;
        _own = new FrameStatistics(_options.Dialect);
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress, wakeOnPost: true);

        // Only where something waits for room in it: a replay.
        bool isWokenByPops = _options.RecordedFiles.Count > 0 || _options.StopsWhenAllLinksEnd;
        _autopilot = Send<LinkFrame>(MessageNames.AutopilotFrames, wakeOnPop: isWokenByPops);
        _outgoing = Receive<OutgoingFrame>(MessageNames.OutgoingFrames, OutgoingCapacity, QueueFullMode.DropOldest);
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _position = new OwnPosition(_options.Links.Count > 0 ? _options.PositionRateHz : 0);
        _tracks = _options.SendsTargets == true && _options.Links.Count > 0
            ? Subscribe<TrackList>(MessageNames.Tracks)
            : null;
        _channels = OpenVehicleMessages();
        if (_channels.Length > 0)
            _vehicleMessageStatus = Publish<VehicleMessageStatus>(MessageNames.VehicleMessages);
        _subscriptions = OpenSubscriptions();
        _droppedIn = new long[_options.Count];
        _signing = _options.Signing is { } signing ? MakeSigning(signing) : null;
        if (_options.Recording is { } recording && _options.Links.Count > 0)
        {
            _recorder = MakeRecorder(recording);
            _recording = AttachWriter("recording", _recorder, recording.FramesWaiting);
            _recordingStatus = Publish<RecordingStatus>(MessageNames.Recording);
        }

        // A frame is forwarded by the thread that has read it.
        RunsOnReaders = true;
        foreach (IByteLink link in _options.Links)
            AddLink(link);
        foreach (RecordedFile file in _options.RecordedFiles)
            AddRecordedFile(file);
    }

    /// <summary>What came in over each link, counted where its frames are made. Any thread.</summary>
    public IReadOnlyList<LinkSummary> SummariseLinks() => _ports.Select(p => p.Summarise()).ToArray();

    /// <summary>
    /// The frames of our own that were to be sent, whether or not a link could take them. Any thread.
    /// </summary>
    public IReadOnlyList<FrameCount> CountOwnFrames() => _own.Counts();

    /// <inheritdoc/>
    protected override void Startup()
    {
        StartExchange();
        PostStatus();
    }

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        _signing?.Advance(Clock.GetUtcNow(), Now);
        if (_ownAddress.Fetch() && _ownAddress.Value.IsKnown)
            _router.SetOwnAddress(_ownAddress.Value.SystemId, _ownAddress.Value.ComponentId);

        foreach (LinkPort port in _ports)
            TakeFrames(port);
        SendOwnFrames();
        SendPosition();
        SendTargets();
        ExchangeVehicleMessages();
        SendPings();
        SendWaiting();

        if (Now >= _nextStatus)
            PostStatus();
        if (_options.StopsWhenAllLinksEnd)
            StopAtTheEnd();
        WakeUpDelay = Earliest(_position.Period < IdleDelay ? _position.Period : IdleDelay);
    }

    /// <inheritdoc/>
    protected override void Shutdown()
    {
        SendOwnFrames();
        EndVehicleMessages();
        SendWaitingAtTheEnd();
        FlushLinks(TimeSpan.MaxValue);
        PostStatus();
        LogDrops(isEnd: true);
        ReportAddresses(isEnd: true);
        ReportRecording(isEnd: true);
        _signing?.Save();
    }

    private void AddLink(IByteLink link)
    {
        int number = _ports.Count;
        LinkSettings settings = _options.SettingsOf(number);
        bool isWire = link.Url.StartsWith("serial:", StringComparison.OrdinalIgnoreCase);
        var tally = new FrameStatistics(_options.Dialect, isWire);
        var source = new MavlinkLinkSource(link, number, _options.Dialect, tally, settings.FlushAfter);
        var target = new LinkFrameTarget(link);
        _ports.Add(new LinkPort(
            number,
            link.Url,
            tally,
            AttachReader($"link {number} in", source, _options.FramesWaitingIn, QueueFullMode.DropOldest),
            AttachWriter($"link {number} out", target, _options.FramesWaitingOut, QueueFullMode.DropOldest),
            Publish<LinkStatus>(MessageNames.LinkStatus(number)),
            () => source.BytesLost,
            () => source.IncompatibleFrames,
            target,
            link,
            file: null,
            settings,
            new TunnelRateLimiter(Math.Min(
                settings.BytesPerSecond ?? int.MaxValue, _options.VehicleMessageBytesPerSecond),
                LinkPort.MaxTunnelLength),
            MakeScheduler(number)));
        _router.SetLink(
            number,
            settings.IsListenOnly ? MavlinkLinkRules.Send
            : settings.IsReceiveOnly ? MavlinkLinkRules.ForwardFrom
            : MavlinkLinkRules.Live);
    }

    private void AddRecordedFile(RecordedFile file)
    {
        int number = _ports.Count;
        var tally = new FrameStatistics(_options.Dialect);
        long origin = _options.RecordedFiles.Min(f => f.StartUtcMicroseconds);
        _ports.Add(new LinkPort(
            number,
            file.Url.ToString(),
            tally,
            AttachReader(
                $"link {number} in", new RecordedFrameSource(file, number, origin, tally), _options.FramesWaitingIn,
                QueueFullMode.Wait),
            writer: null,
            Publish<LinkStatus>(MessageNames.LinkStatus(number)),
            () => file.BytesLost,
            () => file.IncompatibleFrames,
            target: null,
            link: null,
            file,
            _options.SettingsOf(number),
            new TunnelRateLimiter(_options.VehicleMessageBytesPerSecond, LinkPort.MaxTunnelLength),
            scheduler: null));

        // What was recorded is never sent to a live link.
        _router.SetLink(number, MavlinkLinkRules.ReceiveOnly);
    }

    // Frames of a recorded log stay where they are while Autopilot Interface has no room for them; its next pop wakes
    // us.
    private void TakeFrames(LinkPort port)
    {
        for (int taken = 0; taken < _options.FramesWaitingIn; taken++)
        {
            // We alone push into that queue, so room that is there now stays there.
            if (port.IsRecorded && !HasRoom(_autopilot))
                return;
            if (!port.Reader.TryPop(out LinkFrame frame))
                return;
            port.CountReceived(frame);
            if (!port.Admits(frame.Frame) || !IsAccepted(port, frame.Frame))
                continue;
            port.NoteHeartbeat(frame);
            port.NoteRadio(frame);
            if (!IsToBeRouted(port, frame.Frame))
            {
                _router.Learn(port.Number, frame.Frame, frame.IsChecked);
                continue;
            }

            if (!port.IsRecorded)
                Record(frame);
            TakePing(port, frame);
            Route(frame, port.IsRecorded);
        }

        // A link that floods us may not keep the others, and a stop, waiting: the rest in the next unit of work, which
        // is at once.
        WakeUp();
    }

    private void Route(in LinkFrame frame, bool isRecorded)
    {
        MavlinkFrame mavlink = frame.Frame;

        // In a log our own part may come before our system id is known from the vehicle.
        OwnAddress own = _ownAddress.Value;
        if (isRecorded && !own.IsKnown && mavlink.ComponentId == own.ComponentId)
            return;

        MavlinkRoute route = _router.Route(
            frame.Link, mavlink, frame.TargetSystemId, frame.TargetComponentId, frame.IsChecked);

        // A log is no network: whatever its target was then, it is part of the flight that is replayed now.
        bool isReplayed = isRecorded && frame.IsChecked && route.Reason != MavlinkRouteReason.OurOwn;
        bool isTime = IsTimeOfOurVehicle(frame, own);
        if (route.DeliverLocally || isReplayed || isTime)
            Deliver(frame, isReplayed || isTime || frame.IsFor(own.SystemId, own.ComponentId));
        Forward(route.ForwardTo, mavlink);
    }

    // PX4 1.14 leaves the target of its TIMESYNC answers uninitialised; whose answer it is the time in it says.
    private static bool IsTimeOfOurVehicle(in LinkFrame frame, OwnAddress own)
        => frame.IsChecked && frame.Frame.MessageId == Timesync.MavlinkId && frame.Frame.SystemId == own.SystemId
            && frame.Frame.ComponentId != own.ComponentId;

    // Autopilot Interface first: subscriptions never hold it up.
    private void Deliver(in LinkFrame frame, bool isForComputer)
    {
        if (isForComputer && !TakeVehicleMessage(frame) && _autopilot.Push(frame) == PushResult.Rejected)
            _droppedIn[frame.Link]++;
        DeliverToSubscriptions(frame, isForComputer);
    }

    private void SendOwnFrames()
    {
        while (_outgoing.TryPop(out OutgoingFrame outgoing))
        {
            if (outgoing.ValidUntil != TimeSpan.Zero && Now > outgoing.ValidUntil)
            {
                _expired++;
                continue;
            }

            if (!_options.Dialect.TryGetMessage(outgoing.Frame.MessageId, out MavlinkMessageInfo message))
            {
                Log($"{outgoing.Frame} is not sent: the dialect does not know its id");
                continue;
            }

            SendOwn(
                _router.RouteOwn(outgoing.Frame, message), outgoing.Frame, message.CrcExtra, outgoing.ValidUntil);
        }
    }

    private void Forward(ulong links, in MavlinkFrame frame)
    {
        if (links == 0)
            return;
        foreach (LinkPort port in _ports)
        {
            if ((links & (1UL << port.Number)) != 0)
                Forward(port, frame);
        }
    }

    private void SendOwn(ulong links, in MavlinkFrame frame, byte crcExtra, TimeSpan validUntil = default)
    {
        LinkPort? recorded = FindLinkToRecord(links, frame);
        foreach (LinkPort port in _ports)
        {
            if ((links & (1UL << port.Number)) != 0)
                SendOwn(port, frame, crcExtra, validUntil, port == recorded);
        }

        _own.Count(frame, isChecked: true);
    }

    private void PostStatus()
    {
        _nextStatus = Now + StatusPeriod;
        ForwardRadioStatus();
        foreach (LinkPort port in _ports)
            port.PostStatus(Now, _options.SilentAfter, _droppedIn[port.Number]);

        PostVehicleMessages();
        LogDrops(isEnd: false);
        ReportSigning();
        ReportAddresses(isEnd: false);
        ReportRecording(isEnd: false);
    }

    private void LogDrops(bool isEnd)
    {
        long dropped = _outgoing.Counters.Dropped + _expired;
        if (_ownDrops.IsDue(dropped, Now, isEnd))
            Log($"{dropped} frames of our own were dropped so far: more came than could be sent in time");
        foreach (SubscriptionPort subscription in _subscriptions)
        {
            long lost = subscription.Counters.Dropped;
            if (subscription.Drops.IsDue(lost, Now, isEnd))
                Log($"{lost} frames for queue '{subscription.Queue}' were dropped so far: it is full, since its "
                    + "manager receives too slowly");
        }
    }

    // Not before everything is handled: what is still to be read or popped wakes us again.
    private void StopAtTheEnd()
    {
        bool isOver = _ports.TrueForAll(p => p.HasEnded && p.Reader.Counters.Resident == 0)
            && _autopilot.Counters.Resident == 0;
        if (!isOver)
            return;
        PostStatus();
        StopSystem(_ports.Count == 1 ? "the recorded flight is over" : "all links have ended");
    }

    private static bool HasRoom<T>(QueueSender<T> queue)
    {
        QueueCounters counters = queue.Counters;
        return counters.Resident < counters.Capacity;
    }
}
