using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>PX4's multirotor: puts the controller, its telemetry, parameters, events and commands together.</summary>
internal sealed class Px4Autopilot : IVehicleAutopilot
{
    private const double PackAmpereHours = 8;
    private static readonly TimeSpan HeartbeatEvery = TimeSpan.FromSeconds(1);

    private readonly Px4Parameters _parameters;
    private readonly WorldFrame _frame;
    private readonly ulong _uid;
    private readonly Gimbal _mount;
    private readonly double _stepSeconds;
    private readonly SimulationRandom _garbage;
    private readonly ILinkSink _sink;
    private readonly Px4Links _links;
    private readonly Px4Events _events;
    private readonly Px4Controller _controller;
    private readonly Px4Telemetry _telemetry;
    private readonly Px4ParameterService _service;
    private readonly Px4MissionService _missions;
    private readonly StationService _stations;
    private readonly Px4FrameDispatcher _dispatcher;
    private TimeSpan _nextHeartbeat;
    private int _switchCount;

    /// <param name="parameters">What is stored.</param>
    /// <param name="frame">Of the world.</param>
    /// <param name="uid">The number of the board.</param>
    /// <param name="mount">Of the camera.</param>
    /// <param name="stepSeconds">The length of a step.</param>
    /// <param name="garbage">What stands in fields that it does not set.</param>
    /// <param name="sink">Takes what it sends.</param>
    /// <param name="startTime">Of its first heartbeat after a reboot; null: it has been on for long.</param>
    public Px4Autopilot(
        Px4Parameters parameters, WorldFrame frame, ulong uid, Gimbal mount, double stepSeconds,
        SimulationRandom garbage, ILinkSink sink, TimeSpan? startTime = null)
    {
        (_parameters, _frame, _uid, _mount) = (parameters, frame, uid, mount);
        (_stepSeconds, _garbage, _sink) = (stepSeconds, garbage, sink);
        _nextHeartbeat = startTime ?? TimeSpan.Zero;
        var situation = new Px4Situation(parameters, new Px4Sticks(), stepSeconds);
        var fence = new Px4Fence(frame);
        _links = new Px4Links(sink.LinkCount);
        _events = new Px4Events(sink, _links);
        var checks = new Px4Checks(situation, _links, _events, fence);
        _controller = new Px4Controller(situation, checks, _events, frame);
        _telemetry = new Px4Telemetry(_controller, _links, frame, uid, sink);
        _service = new Px4ParameterService(parameters, _controller.ChangeParameters, () => SystemId, sink);
        var setPoints = new Px4SetPointReader(_controller, _telemetry, frame);
        var requests = new Px4RequestHandler(_controller, _links, _telemetry, sink);
        _missions = new Px4MissionService(fence, () => SystemId, sink)
        {
            MissionStored = () => _controller.JumpTo(0),
            CurrentSet = _controller.JumpTo,
        };
        _telemetry.ReportMission = link => _missions.ReportCurrent(_links.Now, link);
        _stations = new StationService(() => SystemId, new MavlinkMemoryFiles(), sink.SendNumbered);
        (_controller.Mission.Items, _controller.Mission.Places) = (_missions, ReadPlace);
        var handler = new Px4CommandHandler(_controller, setPoints, requests, mount, frame);
        var commands = new CommandService(() => SystemId, (r, link) => handler.Execute(r, link), sink.SendNumbered);
        _dispatcher = new Px4FrameDispatcher(
            _controller, commands, handler, setPoints, _service, _missions, _stations, _events, _links, garbage, sink);

        bool ReadPlace(MavFrame axes, int x, int y, float altitude, out NedVector place)
            => setPoints.TryReadPlace(axes, x, y, altitude, out place);
    }

    public byte SystemId => _parameters.OwnSystemId;

    public double BatteryCapacityAmpereHours => PackAmpereHours;

    public bool IsArmed => _controller.IsArmed;

    public uint CustomMode => (uint)_controller.Mode;

    public string ModeName => Px4ModeNames.NameOf(_controller.Mode);

    public bool HasPosition => _controller.Situation.HasPosition;

    /// <summary>PREFLIGHT_REBOOT_SHUTDOWN is not simulated; a scripted reboot is.</summary>
    public bool WantsReboot => false;

    public void SetParameter(string name, float value) => _parameters.Set(name, value);

    public IVehicleAutopilot Restarted(TimeSpan time, TimeSpan bootTime, bool staysArmed)
    {
        var next = new Px4Autopilot(
            _parameters, _frame, _uid, _mount, _stepSeconds, _garbage, _sink, time + bootTime)
        {
            _switchCount = _switchCount,
        };
        next._missions.Restore(_missions);
        if (staysArmed && !_controller.Situation.IsLanded)
            next._controller.StayArmed(_controller);
        return next;
    }

    public bool TrySetMode(uint customMode)
        => Px4ModeNames.IsFlown(customMode) && _controller.TrySetMode((Px4Mode)customMode);

    public MotionCommand Step(in VehicleSenses senses)
    {
        _links.Now = senses.Time;
        UseRadio(senses);
        return _controller.Step(senses);
    }

    public void Observe(in AutopilotState state)
    {
        _events.BootMilliseconds = (uint)(state.BootMicroseconds / 1000);
        _telemetry.Update(state);
    }

    public void Handle(in MavlinkFrame frame, long bootNanoseconds, int link)
    {
        _dispatcher.Handle(frame, bootNanoseconds, link);

        // It forwards what is broadcast (MAV_0_FORWARD), as recorded.
        if (link == SecondLink.Number && frame.MessageId == Heartbeat.MavlinkId)
            _sink.Forward(frame);
    }

    public void SendWhatIsDue(TimeSpan time, long bootNanoseconds)
    {
        if (time >= _nextHeartbeat)
        {
            _nextHeartbeat += HeartbeatEvery;
            _telemetry.SendAll(Heartbeat.MavlinkId);
        }

        _events.Step(time);
        for (int link = 0; link < _links.Count; link++)
            _links.Streams(link).Send(time, link, _telemetry);
        _service.Step(time);
        _missions.Step(time, _controller.IsArmed && _controller.Mode == Px4Mode.Mission);
        _stations.Step(time);
    }

    // A remote control counts where COM_RC_IN_MODE asks for one: its sticks are in the middle, its switch takes modes.
    private void UseRadio(in VehicleSenses senses)
    {
        bool isUsed = _parameters.ManualInput.Whole is 0 or 2 or 3;
        _telemetry.IsRadioReceived = isUsed && senses.IsRadioReceived;
        if (isUsed && senses.IsRadioReceived)
            _controller.Situation.Sticks.ReceiveCentred(senses.Time);
        if (senses.SwitchCount == _switchCount)
            return;
        _switchCount = senses.SwitchCount;
        if (senses.ModeOfSwitch is { } mode)
            TrySetMode(mode);
    }
}
