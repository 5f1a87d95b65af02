using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Keeps the state of the vehicle by the messages of the autopilot. The first autopilot that is received is ours and
/// stays so, lost or not: a second one on the same net is another aircraft. Time comes in with the frames; no I/O, one
/// thread. Each frame comes in once, by the <c>Update</c> of its message.
/// </summary>
/// <param name="systemId">The system that the autopilot must be of; null for any.</param>
/// <param name="heartbeatTimeout">After what time without a heartbeat the autopilot is lost.</param>
internal sealed partial class VehicleTracker(byte? systemId, TimeSpan heartbeatTimeout)
{
    private readonly FlightModeNames _modeNames = new();
    private readonly MavlinkHeartbeatTracker _heartbeats = new(capacity: 1, heartbeatTimeout);
    private readonly BatteryTracker _battery = new();
    private VehicleState _state = Unknown;

    /// <summary>The state before anything was received.</summary>
    public static VehicleState Unknown => new()
    {
        BatteryVolts = double.NaN,
        BatteryAmperes = double.NaN,
        BatteryRemaining = double.NaN,
        BatteryConsumedAmpereHours = double.NaN,
        Satellites = byte.MaxValue,
        WindVelocityNed = new NedVector(double.NaN, double.NaN, double.NaN),
    };

    public ref readonly VehicleState State => ref _state;

    /// <summary>A gimbal of the vehicle has reported its attitude; posted with the next change.</summary>
    public void NoteGimbal(TimeSpan time) => _state.GimbalTime = time;

    /// <summary>When the newest part of the state was true.</summary>
    public TimeSpan NewestTime { get; private set; }

    /// <summary>
    /// The time since boot of the last message that has one, milliseconds; 0 where the autopilot does not know it.
    /// </summary>
    public uint BootTimeMs { get; private set; }

    /// <summary>Whether the autopilot is known and the frame comes from it.</summary>
    public bool IsFromAutopilot(in MavlinkFrame frame)
        => _state.SystemId != 0 && frame.SystemId == _state.SystemId && frame.ComponentId == _state.ComponentId;

    /// <summary>A frame of a message that is no part of the state.</summary>
    public VehicleEvents Update(in LinkFrame frame)
        => Begin(frame, out VehicleEvents events) ? Complete(frame, events) : events;

    /// <summary>A heartbeat of any component.</summary>
    public VehicleEvents Update(in LinkFrame frame, in Heartbeat heartbeat)
        => Stamp(CheckConnection(frame.Time) | Apply(frame.Frame, heartbeat, frame.Time), frame.Time);

    /// <summary>
    /// Says whether the autopilot was lost by a time. Frames bring their own, so that a gap between two heartbeats
    /// counts the same whether they were handled at once or late together.
    /// </summary>
    public VehicleEvents CheckConnection(TimeSpan time)
    {
        VehicleEvents events = VehicleEvents.None;
        while (_heartbeats.TryTakeEvent(time, out MavlinkComponentEvent happened, out _))
        {
            events |= happened switch
            {
                MavlinkComponentEvent.Appeared => VehicleEvents.Found,
                MavlinkComponentEvent.Lost => Lose(),
                MavlinkComponentEvent.Returned => VehicleEvents.FoundAgain,
                _ => VehicleEvents.Rebooted,
            };
        }

        return events;
    }

    private VehicleEvents Lose()
    {
        _state.IsConnected = false;
        TimeSpan lostAt = _state.LastHeartbeatTime + heartbeatTimeout;
        if (lostAt > NewestTime)
            NewestTime = lostAt;
        return VehicleEvents.Changed | VehicleEvents.Lost;
    }

    // A connection may be lost, and state with it, by the time that any frame brings.
    private bool Begin(in LinkFrame frame, out VehicleEvents events)
    {
        events = CheckConnection(frame.Time);
        if (IsFromAutopilot(frame.Frame))
            return true;
        events = Stamp(events | VehicleEvents.OfOther, frame.Time);
        return false;
    }

    /// <param name="frame">A frame of the autopilot, whose message was applied.</param>
    /// <param name="applied">What came of that.</param>
    private VehicleEvents Complete(in LinkFrame frame, VehicleEvents applied)
    {
        _heartbeats.Handle(frame.Frame, frame.Time);
        return Stamp(applied | CheckConnection(frame.Time), frame.Time);
    }

    private VehicleEvents Stamp(VehicleEvents events, TimeSpan time)
    {
        if ((events & VehicleEvents.Changed) != 0 && time > NewestTime)
            NewestTime = time;
        return events;
    }

    private VehicleEvents Apply(in MavlinkFrame frame, in Heartbeat heartbeat, TimeSpan time)
    {
        if (!IsAutopilot(frame, heartbeat))
            return VehicleEvents.OfOther;
        bool isFirst = _state.SystemId == 0;
        if (isFirst ? systemId is { } wanted && wanted != frame.SystemId : !IsFromAutopilot(frame))
            return VehicleEvents.OfOther | VehicleEvents.OtherAutopilot;

        _heartbeats.Handle(frame, heartbeat, time);
        VehicleEvents events = VehicleEvents.Changed | CheckConnection(time);
        _state.SystemId = frame.SystemId;
        _state.ComponentId = frame.ComponentId;
        _state.IsConnected = true;
        _state.LastHeartbeatTime = time;
        _state.Autopilot = heartbeat.Autopilot;
        _state.VehicleType = heartbeat.Type;
        _state.BaseMode = heartbeat.BaseMode;
        _state.CustomMode = heartbeat.CustomMode;
        _state.Mode = _modeNames.NameOf(heartbeat);
        _state.IsArmed = (heartbeat.BaseMode & MavModeFlag.SafetyArmed) != 0;
        _state.SystemStatus = heartbeat.SystemStatus;
        return events;
    }

    // "INVALID" is what everything that is no flight controller says of its autopilot (MAVLink guide,
    // "Heartbeat/Connection Protocol"); some ground stations and companions say otherwise, so their types are left out
    // too.
    private static bool IsAutopilot(in MavlinkFrame frame, in Heartbeat heartbeat)
        => frame.SystemId != 0
        && frame.ComponentId != 0
        && heartbeat.Autopilot != MavAutopilot.Invalid
        && heartbeat.Type is not (MavType.Gcs or MavType.OnboardController or MavType.Gimbal or MavType.Adsb
            or MavType.Camera
            or MavType.ChargingStation or MavType.Flarm or MavType.Servo or MavType.Odid or MavType.Battery
            or MavType.Log
            or MavType.Osd or MavType.Imu or MavType.Gps or MavType.Winch or MavType.Illuminator or MavType.Gripper
            or MavType.Radio);
}
