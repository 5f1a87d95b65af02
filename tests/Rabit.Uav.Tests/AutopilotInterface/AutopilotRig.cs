using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>An Autopilot Interface in virtual time, with the test in the place of Communications.</summary>
internal sealed class AutopilotRig : IDisposable
{
    public const byte System = 1;
    public const byte Autopilot = 1;
    public const MavModeFlag Armed = MavModeFlag.CustomModeEnabled | MavModeFlag.SafetyArmed;

    private readonly QueueSender<LinkFrame> _frames;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly MessageSubscriber<RecentItems<StatusText>> _texts;
    private readonly MessageSubscriber<RecentItems<CommandAcknowledgement>> _acknowledgements;
    private readonly MessageSubscriber<CommandAuthority> _authority;
    private readonly MessageSubscriber<AutopilotStatistics> _statistics;
    private readonly QueueSender<VehicleCommand> _commands;
    private readonly MessagePublisher<LandingTargetObservation> _landingTarget;
    private long _index;

    public AutopilotRig(AutopilotOptions? options = null)
    {
        Manager = new AutopilotManager(options ?? new AutopilotOptions { RequestsRates = false });
        Reactor = new RabitReactor(new VirtualTime(1)) { Manager, Sink, Peers };
        _frames = Reactor.Workspace.Send<LinkFrame>(MessageNames.AutopilotFrames);
        _vehicle = Reactor.Workspace.Subscribe<VehicleState>(MessageNames.VehicleState);
        _ownAddress = Reactor.Workspace.Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _texts = Reactor.Workspace.Subscribe<RecentItems<StatusText>>(MessageNames.StatusTexts);
        _acknowledgements = Reactor.Workspace.Subscribe<RecentItems<CommandAcknowledgement>>(
            MessageNames.CommandAcknowledgements);
        _authority = Reactor.Workspace.Subscribe<CommandAuthority>(MessageNames.CommandAuthority);
        _statistics = Reactor.Workspace.Subscribe<AutopilotStatistics>(MessageNames.AutopilotStatistics);
        _commands = Reactor.Workspace.Send<VehicleCommand>(MessageNames.VehicleCommands);
        _landingTarget = Reactor.Workspace.Publish<LandingTargetObservation>(MessageNames.LandingTarget);
        Reactor.Start();
        Reactor.RunFor(TimeSpan.Zero);
    }

    public RabitReactor Reactor { get; }

    public AutopilotManager Manager { get; }

    public OutgoingSink Sink { get; } = new();

    public AutopilotPeers Peers { get; } = new();

    public CommandAuthority Authority => Fetched(_authority);

    public AutopilotStatistics Statistics => Fetched(_statistics);

    public VehicleState Vehicle => Fetched(_vehicle);

    public TimeSpan VehicleTime
    {
        get
        {
            _vehicle.Fetch();
            return _vehicle.Stamp.Time;
        }
    }

    public int VehiclePosts
    {
        get
        {
            _vehicle.Fetch();
            return _vehicle.Stamp.Version;
        }
    }

    public OwnAddress OwnAddress => Fetched(_ownAddress);

    public RecentItems<StatusText> Texts => Fetched(_texts);

    public RecentItems<CommandAcknowledgement> Acknowledgements => Fetched(_acknowledgements);

    public static Heartbeat Copter(
        CopterMode mode = CopterMode.Stabilize, MavModeFlag flags = MavModeFlag.CustomModeEnabled,
        MavState status = MavState.Standby)
            => new()
            {
                Type = MavType.Quadrotor,
                Autopilot = MavAutopilot.Ardupilotmega,
                BaseMode = flags,
                CustomMode = (uint)mode,
                SystemStatus = status,
                MavlinkVersion = 3,
            };

    public static LinkFrame FrameOf<T>(
        in T message, TimeSpan time, byte system = System, byte component = Autopilot, long index = 0)
        where T : struct, IMavlinkMessage
        => new()
        {
            Frame = MavlinkFrame.Create(message, system, component, (byte)index),
            Index = index,
            Time = time,
            UtcMicroseconds = 1_700_000_000_000_000 + (time.Ticks / 10),
        };

    /// <summary>Hands a message in as if it had just come.</summary>
    public void Send<T>(in T message, byte system = System, byte component = Autopilot, TimeSpan? time = null)
        where T : struct, IMavlinkMessage
        => Push(FrameOf(message, time ?? Reactor.Now, system, component, _index++));

    public void Push(in LinkFrame frame)
    {
        if (_frames.Push(frame) == PushResult.Rejected)
            throw new InvalidOperationException("The queue of frames is full.");
    }

    public void Run(double seconds = 0) => Reactor.RunFor(TimeSpan.FromSeconds(seconds));

    /// <summary>Hands a command in, as Mission Control does.</summary>
    public void Command(in VehicleCommand command) => _commands.Push(command);

    /// <summary>Posts where the marker to land on is, as Image Processing does.</summary>
    public void Post(in LandingTargetObservation target)
    {
        _landingTarget.Value = target;
        _landingTarget.PostStamped(target.Time);
    }

    /// <summary>Heartbeats once a second for so many seconds.</summary>
    public void Beat(int seconds, Heartbeat? heartbeat = null)
    {
        for (int i = 0; i < seconds; i++)
        {
            Send(heartbeat ?? Copter());
            Run(1);
        }
    }

    public void Dispose()
    {
        Reactor.Stop();
        Reactor.Finish();
    }

    private static T Fetched<T>(MessageSubscriber<T> subscriber)
    {
        subscriber.Fetch();
        return subscriber.Value;
    }
}
