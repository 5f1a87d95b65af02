using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Receives the autopilot: turns its frames into the state of the vehicle, keeps its last texts and acknowledgements,
/// knows when it is lost, and asks it for the message rates that the others need. ArduPilot, PX4, or any other in
/// general terms. Where it may, it carries out the commands of Mission Control, until the pilot or the autopilot takes
/// the command away.
/// </summary>
public sealed partial class AutopilotManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "autopilot";

    /// <summary>How many of the last status texts and acknowledgements are posted.</summary>
    public const int RecentItemsKept = 20;

    private const int FramesWaiting = 1024;
    private static readonly TimeSpan IdleDelay = TimeSpan.FromMilliseconds(200);

    private readonly AutopilotOptions _options;
    private readonly QueueReceiver<LinkFrame> _frames;
    // What finds no room is counted by the queue, and shown; each protocol sends again what is not answered.
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<OwnAddress> _ownAddress;
    private readonly MessagePublisher<RecentItems<StatusText>> _statusTexts;
    private readonly MessagePublisher<RecentItems<CommandAcknowledgement>> _acknowledgements;
    private readonly MessagePublisher<AutopilotStatistics> _statistics;
    private readonly VehicleTracker _tracker;
    private readonly VersionRequester _version = new();
    private MavlinkRateClient? _rates;
    private (MavlinkSender Sender, MavlinkAddress Target)? _connection;
    private TimeSpan _checkedUntil;
    private bool _hasNewStatistics;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public AutopilotManager(AutopilotOptions options)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        _executor = new CommandExecutor(_options.MayCommand, _options.MayCommandFixedWing);
        _tracker = new VehicleTracker(_options.SystemId, _options.HeartbeatTimeout);
        _frames = Receive<LinkFrame>(
            MessageNames.AutopilotFrames, FramesWaiting, QueueFullMode.Reject, wakeOnPush: true);
        _outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        _vehicle = Publish(MessageNames.VehicleState, VehicleTracker.Unknown);
        _ownAddress = Publish(MessageNames.OwnAddress, new OwnAddress { ComponentId = _options.ComponentId });
        _statusTexts = Publish(MessageNames.StatusTexts, RecentItems<StatusText>.None);
        _acknowledgements = Publish(MessageNames.CommandAcknowledgements, RecentItems<CommandAcknowledgement>.None);
        _statistics = Publish<AutopilotStatistics>(MessageNames.AutopilotStatistics);
        _commands = Receive<VehicleCommand>(
            MessageNames.VehicleCommands, CommandsWaiting, QueueFullMode.Reject, wakeOnPush: true);
        _answers = Send<VehicleCommandResult>(MessageNames.VehicleCommandResults);
        _authority = Publish(MessageNames.CommandAuthority, _executor.Authority);
        _poses = Send<PoseSample>(MessageNames.Poses);
        PublishSetup();
        _fenceMessage = Publish(MessageNames.AutopilotFence, AutopilotFence.Unknown);
        if (_options.SendsLandingTarget)
            _landingTarget = Subscribe<LandingTargetObservation>(MessageNames.LandingTarget, wakeOnPost: true);
        WakeUpDelay = IdleDelay;
    }

    /// <inheritdoc/>
    protected override void Startup()
    {
        if (_options.SystemId is { } systemId)
            PostOwnAddress(systemId);
        _authority.Post();
    }

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        _executor.BeginRun(Now);
        VehicleEvents events = TakeFrames() | CheckSilence();
        RunSetup();
        RunFence();
        if ((events & VehicleEvents.Changed) != 0)
        {
            _vehicle.Value = _tracker.State;
            _vehicle.PostStamped(_tracker.NewestTime);
        }

        RequestVersion();
        RequestRates();
        RequestTime();
        RunEvents();
        ExecuteCommands();
        SendLandingTarget();
        PostStatistics();
        WakeUpDelay = NextWakeUpDelay();
    }

    private TimeSpan NextWakeUpDelay()
    {
        TimeSpan now = Now;
        bool isBusy = IsSetupBusy || IsFenceBusy || _isFetchingEvents || _executor.IsBusy
            || _clock.Requests.IsFast(now);
        TimeSpan delay = isBusy ? BusyDelay : IdleDelay;
        TimeSpan due = _executor.NextDue(now);
        if (due < now + delay)
            delay = due - now;
        return delay < MinDelay ? MinDelay : delay;
    }

    private VehicleEvents TakeFrames()
    {
        var all = VehicleEvents.None;
        RecentItems<StatusText> texts = _statusTexts.Value;
        RecentItems<CommandAcknowledgement> acknowledgements = _acknowledgements.Value;
        while (_frames.TryPop(out LinkFrame frame))
            all |= TakeFrame(frame);

        TakeTexts(Now);
        if (!ReferenceEquals(texts, _statusTexts.Value))
            _statusTexts.PostStamped(_statusTexts.Value.Newest!.Time);
        if (!ReferenceEquals(acknowledgements, _acknowledgements.Value))
            _acknowledgements.PostStamped(_acknowledgements.Value.Newest!.Time);
        return all;
    }

    // Checked for a moment that is a wake-up delay ago: what had come by then has been handed over by now, even where
    // the whole computer stood still in between.
    private VehicleEvents CheckSilence()
    {
        TimeSpan now = Now;
        if (now - _checkedUntil < IdleDelay)
            return VehicleEvents.None;
        VehicleEvents events = _tracker.CheckConnection(_checkedUntil);
        _checkedUntil = now;
        Count(events);
        Handle(events, now);
        return events;
    }

    // In this order: a frame after a gap shows the loss, then the end of it.
    private void Handle(VehicleEvents events, TimeSpan time)
    {
        if ((events & VehicleEvents.Lost) != 0)
        {
            Log("the autopilot is lost");
            _clock.Requests.Stop();
        }

        if ((events & VehicleEvents.Found) != 0)
        {
            VehicleState vehicle = _tracker.State;
            Log($"autopilot {vehicle.Autopilot} of a {vehicle.VehicleType}, system {vehicle.SystemId}, component "
                + $"{vehicle.ComponentId}");
            PostOwnAddress(vehicle.SystemId);
            MakeClients(vehicle);
        }

        if ((events & VehicleEvents.FoundAgain) != 0)
            Log("the autopilot is back");
        if ((events & VehicleEvents.Rebooted) != 0)
        {
            Log("the autopilot has rebooted");
            HandleReboot(time);
            _setup?.HandleReboot(time);
        }

        if ((events & (VehicleEvents.Found | VehicleEvents.FoundAgain | VehicleEvents.Rebooted)) != 0)
        {
            _rates!.Restart();
            _version.Start(time);
            BeginEvents(time);
            StartRequestingTime(time);
        }
    }

    // Who we are and which vehicle is ours never changes again.
    private void MakeClients(in VehicleState vehicle)
    {
        OwnAddress own = _ownAddress.Value;
        var target = new MavlinkAddress(vehicle.SystemId, vehicle.ComponentId);

        // Communications numbers and signs what goes out.
        var sender = new MavlinkSender(own.SystemId, own.ComponentId);
        _connection = (sender, target);
        _executor.Connect(sender, target);
        _rates = new MavlinkRateClient(
            sender, target, RatesFor(vehicle).Select(r => (r.MessageId, r.Hertz)).ToArray());
        MakeSetup(vehicle, sender, target);
        MakeEvents(sender, target);
        if (_options.WatchesFence)
            _fence = new FenceWatcher(sender, target, Log);
    }

    private void RequestVersion()
    {
        if (_options.RequestsRates && _connection is { } connection && _tracker.State.IsConnected
            && _version.TryNext(Now, connection.Sender, connection.Target, out MavlinkFrame frame))
            _ = _outgoing.Push(new OutgoingFrame { Frame = frame });
    }

    private void RequestRates()
    {
        if (!_options.RequestsRates || _rates is null)
            return;
        while (_tracker.State.IsConnected && _rates.TryTakeFrame(Now, out MavlinkFrame frame))
            _ = _outgoing.Push(new OutgoingFrame { Frame = frame });
        while (_rates.TryTakeAnswer(out MavlinkStreamRate rate))
            TakeRateAnswer(rate);
        RateRequestCounts counts = _statistics.Value.RateRequests;
        if (counts.Sent != _rates.Requests)
            SetRateRequests(new RateRequestCounts(counts.Accepted, counts.Refused, counts.Unanswered, _rates.Requests));
    }

    private void TakeRateAnswer(in MavlinkStreamRate rate)
    {
        RateRequestCounts counts = _statistics.Value.RateRequests;
        int accepted = rate.Answer == MavlinkRateAnswer.Accepted ? 1 : 0;
        int refused = rate.Answer == MavlinkRateAnswer.Refused ? 1 : 0;
        int unanswered = rate.Answer == MavlinkRateAnswer.Unanswered ? 1 : 0;
        SetRateRequests(new RateRequestCounts(
            counts.Accepted + accepted, counts.Refused + refused, counts.Unanswered + unanswered, counts.Sent));
        if (refused > 0)
            Log($"the autopilot refuses a rate for {NameOf(rate.MessageId)}");
        if (unanswered > 0)
            Log($"the autopilot does not answer to a rate for {NameOf(rate.MessageId)}");
    }

    private void Count(VehicleEvents events)
    {
        _hasNewStatistics |= events != VehicleEvents.None;
        ref AutopilotStatistics statistics = ref _statistics.Value;
        if ((events & VehicleEvents.OfOther) != 0)
            statistics.FramesOfOthers++;
        if ((events & VehicleEvents.OtherAutopilot) != 0)
            statistics.HeartbeatsOfOtherAutopilots++;
        if ((events & VehicleEvents.Refused) != 0)
            statistics.RefusedMessages++;
        if ((events & VehicleEvents.Lost) != 0)
            statistics.Losses++;
        if ((events & VehicleEvents.Rebooted) != 0)
            statistics.Reboots++;
    }

    private void SetRateRequests(in RateRequestCounts counts)
    {
        _statistics.Value.RateRequests = counts;
        _hasNewStatistics = true;
    }

    private void PostStatistics()
    {
        if (!_hasNewStatistics)
            return;
        _hasNewStatistics = false;
        _statistics.Value.PoseTimeErrorSeconds = _clock.ErrorSecondsAt(Now);
        _statistics.Value.RoundTripSeconds = _clock.RoundTripSeconds;
        _statistics.Post();
    }

    private void PostOwnAddress(byte systemId)
    {
        if (_ownAddress.Value.IsKnown)
            return;
        _ownAddress.Value.SystemId = systemId;
        _ownAddress.Post();
    }

    private string NameOf(int messageId)
        => _options.Dialect.TryGetMessage(messageId, out MavlinkMessageInfo message)
            ? message.Name
            : "an unknown message";
}
