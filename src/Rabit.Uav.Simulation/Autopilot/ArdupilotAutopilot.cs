using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// ArduPilot's Copter: puts the flight controller, its telemetry, parameters and commands together.
/// </summary>
internal sealed class ArdupilotAutopilot : IVehicleAutopilot
{
    private static readonly TimeSpan HeartbeatEvery = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan TimesyncEvery = TimeSpan.FromSeconds(10);

    private readonly IFrameSink _sink;
    private readonly AutopilotAddress _address;
    private readonly ParameterStore _store;
    private readonly WorldFrame _frame;
    private readonly ulong _uid;
    private readonly Gimbal _mount;
    private readonly MissionService _missions;
    private readonly StationService _stations;
    private readonly CommandHandler _commands;
    private readonly ParameterService _parameters;
    private readonly StreamSchedule _streams = new();
    private readonly FlightController _controller;
    private readonly TelemetrySender _telemetry;
    private readonly FrameDispatcher _dispatcher;
    private readonly Action<int> _sendMessage;
    private TimeSpan _nextHeartbeat;
    private TimeSpan _nextTimesync;
    private double _consumed;
    private double? _consumedBefore;

    /// <param name="parameters">What is stored.</param>
    /// <param name="frame">Of the world.</param>
    /// <param name="uid">The number of the board.</param>
    /// <param name="mount">Of the camera.</param>
    /// <param name="stepSeconds">The length of a step.</param>
    /// <param name="sink">Takes what it sends.</param>
    /// <param name="startTime">Of its first heartbeat after a reboot; null: it has been on for long.</param>
    public ArdupilotAutopilot(
        ParameterStore parameters, WorldFrame frame, ulong uid, Gimbal mount, double stepSeconds, IFrameSink sink,
        TimeSpan? startTime = null)
    {
        (_store, _frame, _uid, _mount, _sink) = (parameters, frame, uid, mount, sink);
        _nextHeartbeat = startTime ?? TimeSpan.Zero;
        _nextTimesync = _nextHeartbeat + TimesyncEvery;
        _controller = new FlightController(_store, Say, startTime);
        _controller.Situation.StepSeconds = stepSeconds;
        _address = new AutopilotAddress(_store);
        _telemetry = new TelemetrySender(_controller, frame, uid, sink);
        _sendMessage = _telemetry.Send;
        _parameters = new ParameterService(_store, _address, sink);
        var targets = new TargetReader(_controller, _telemetry, frame);
        _missions = new MissionService(frame, _address, _telemetry, sink)
        {
            FenceStored = UseFence,
            MissionStored = _controller.Auto.Rewind,
            CurrentSet = _controller.JumpTo,
        };
        (_controller.Auto.Mission, _controller.Auto.Places, _controller.Auto.Say) =
            (_missions, targets.TryReadPlace, Say);
        _telemetry.ReportMission = () => _missions.ReportCurrent(_controller.Situation.Time);
        _stations = new StationService(
            () => _address.SystemId, new ArdupilotFiles(_store), (_, frame) => sink.SendNumbered(frame));
        _commands = new CommandHandler(_controller, targets, _streams, _telemetry, mount, sink, Say);
        var commands = new CommandService(
            () => _address.SystemId, (request, _) => _commands.Execute(request.Command),
            (_, answer) => sink.SendNumbered(answer));
        _dispatcher = new FrameDispatcher(
            _controller, commands, _commands, targets, _parameters, _missions, _stations, _streams, _address, sink);
        _controller.Armed = SetHome;
        _controller.ModeChanged = () => _telemetry.Send(Heartbeat.MavlinkId);
        _controller.Failsafes.Fence.BreachBegan = () => _telemetry.Send(FenceStatus.MavlinkId);
    }

    public byte SystemId => _address.SystemId;

    public double BatteryCapacityAmpereHours => _store.Battery.Capacity.Value / 1000;

    public bool IsArmed => _controller.IsArmed;

    public uint CustomMode => (uint)_controller.Mode;

    public string ModeName => CopterModes.NameOf(_controller.Mode);

    /// <summary>Once known, it reports a position, also while it does not count on it.</summary>
    public bool HasPosition => _controller.HasOrigin;

    public bool WantsReboot => _commands.WantsReboot;

    public void SetParameter(string name, float value) => _store.Set(name, value);

    public IVehicleAutopilot Restarted(TimeSpan time, TimeSpan bootTime, bool staysArmed)
    {
        var next = new ArdupilotAutopilot(
            _store, _frame, _uid, _mount, _controller.Situation.StepSeconds, _sink, time + bootTime)
        {
            _consumedBefore = _consumed,
        };
        next._missions.Restore(_missions);
        if (staysArmed && !_controller.Situation.IsLanded)
            next._controller.StayArmed(_controller);
        return next;
    }

    public bool TrySetMode(uint customMode) => _controller.TrySetMode(customMode);

    public MotionCommand Step(in VehicleSenses senses)
    {
        _consumed = senses.ConsumedAmpereHours;
        VehicleSenses counted = senses;
        counted.ConsumedAmpereHours = _consumed - (_consumedBefore ?? 0);
        Feel(counted);
        return _controller.Step(counted);
    }

    // It counts the charge from its start on, and takes the battery for full then.
    public void Observe(in AutopilotState state)
    {
        AutopilotState reported = state;
        if (_consumedBefore is { } before)
        {
            reported.ConsumedAmpereHours -= before;
            double remaining = Math.Max(0, 1 - (reported.ConsumedAmpereHours / BatteryCapacityAmpereHours));
            reported.BatteryRemaining = double.IsNaN(reported.BatteryRemaining) ? double.NaN : remaining;
        }

        _telemetry.Update(reported);
    }

    public void Handle(in MavlinkFrame frame, long bootNanoseconds, int link)
    {
        _dispatcher.Handle(frame, bootNanoseconds);

        // It passes on what is broadcast: the companion receives the ground station's heartbeats.
        if (link == SecondLink.Number && frame.MessageId == Heartbeat.MavlinkId)
            _sink.Forward(frame);
    }

    public void SendWhatIsDue(TimeSpan time, long bootNanoseconds)
    {
        if (time >= _nextHeartbeat)
        {
            // Where another interval is asked for, the schedule sends it.
            _nextHeartbeat += HeartbeatEvery;
            if (_streams.IntervalOf(Heartbeat.MavlinkId) == 0)
                _telemetry.Send(Heartbeat.MavlinkId);
        }

        if (time >= _nextTimesync)
        {
            // ArduPilot asks too, and marks its questions with its system id.
            _nextTimesync += TimesyncEvery;
            _sink.Send(new Timesync { Ts1 = bootNanoseconds + _address.SystemId });
        }

        _streams.Send(time, _sendMessage);
        _parameters.Step(time);
        _missions.Step(time, _controller.IsAuto);
        _stations.Step(time);
    }

    private void Feel(in VehicleSenses senses)
    {
        FlightSituation situation = _controller.Situation;
        situation.Time = senses.Time;
        situation.Position = senses.Position;
        situation.Velocity = senses.Velocity;
        situation.Yaw = senses.Yaw;
        situation.TouchesGround = senses.TouchesGround;
        if (_controller.HasOrigin || !senses.HasGps)
            return;

        _controller.HasOrigin = true;
        situation.Home = situation.Position;
        _telemetry.Origin = _telemetry.Home = situation.Position;
        Say(MavSeverity.Info, "EKF3 IMU0 is using GPS");
        Say(MavSeverity.Info, "EKF3 IMU1 is using GPS");
    }

    private void SetHome()
    {
        if (!_controller.HasOrigin)
            return;
        FlightSituation situation = _controller.Situation;
        situation.Home = situation.Position;
        _telemetry.Home = situation.Position;
        _telemetry.Send(HomePosition.MavlinkId);
        _telemetry.Send(GpsGlobalOrigin.MavlinkId);
    }

    private void UseFence(FenceShapes shapes, int items)
    {
        _controller.Failsafes.Fence.Shapes = shapes;
        if (_store.Fence.Total.Value.Equals(items))
            return;
        _store.Fence.Total.Set(items);
        _parameters.Report(_store.Fence.Total, _controller.Situation.Time);
        Say(MavSeverity.Debug, "Fence Indexed OK");
    }

    private void Say(MavSeverity severity, string text)
        => _sink.Send(new Statustext { Severity = severity, Text = new Text50(text) });
}
