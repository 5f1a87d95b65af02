using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The ground station, 255/190, on a second link of the vehicle: its heartbeats, and what it commands by the script.
/// Its frames do not pass the link of the companion.
/// </summary>
internal sealed class SecondLink(SimulationOptions options, WorldFrame frame, FaultScript script)
{
    /// <summary>Of the vehicle's links; that of the companion is 0.</summary>
    public const int Number = 1;

    public const byte SystemId = 255;
    public const byte ComponentId = (byte)MavComponent.Missionplanner;

    private static readonly TimeSpan HeartbeatEvery = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan TargetEvery = TimeSpan.FromMilliseconds(100);

    private readonly Queue<MavlinkFrame> _outbox = new();
    private readonly TimeSpan[] _next = new TimeSpan[options.Faults.Count];
    private TimeSpan _nextHeartbeat;
    private byte _sequence;

    /// <summary>Queues what is due at a time for the vehicle.</summary>
    /// <param name="time">By the clock of the run.</param>
    /// <param name="vehicle">Its system id.</param>
    public void Step(TimeSpan time, byte vehicle)
    {
        if (options.HasGroundStation && time >= _nextHeartbeat)
        {
            _nextHeartbeat += HeartbeatEvery;
            if (!script.IsOn(ScriptedFaultKind.GroundStationSilent, time))
                Send(new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid, MavlinkVersion = 3 });
        }

        for (int index = 0; index < options.Faults.Count; index++)
        {
            if (options.Faults[index].Kind == ScriptedFaultKind.OtherCommander)
                Command(index, time, vehicle);
        }
    }

    public bool TryTakeFrame(out MavlinkFrame taken)
    {
        taken = default;
        if (_outbox.Count == 0)
            return false;
        taken = _outbox.Dequeue();
        return true;
    }

    private void Command(int index, TimeSpan time, byte vehicle)
    {
        ScriptedFault fault = options.Faults[index];
        bool isFirst = _next[index] == TimeSpan.Zero;
        if (time < fault.At || time < _next[index] || (!isFirst && time - fault.At >= fault.Duration))
            return;
        _next[index] = time + TargetEvery;
        if (fault.Place is not { } place)
            Send(Target(vehicle, default, (PositionTargetTypemask)0b1101_1100_0111));
        else if (fault.Duration == TimeSpan.Zero)
            SendReposition(vehicle, frame.ToPlace(place - NedPosition.Origin));
        else
            Send(Target(vehicle, frame.ToPlace(place - NedPosition.Origin), (PositionTargetTypemask)0b1101_1111_1000));
    }

    // Heights above sea level: this frame means the same to every autopilot.
    private void SendReposition(byte vehicle, GeodeticPosition place) => Send(new CommandInt
    {
        TargetSystem = vehicle,
        TargetComponent = AutopilotAddress.ComponentId,
        Command = MavCmd.DoReposition,
        Frame = MavFrame.GlobalInt,
        Param1 = -1,
        Param2 = (float)MavDoRepositionFlags.ChangeMode,
        Param4 = float.NaN,
        X = DegE7(place.Latitude.Radians),
        Y = DegE7(place.Longitude.Radians),
        Z = (float)place.AltitudeAmslMetres,
    });

    private static SetPositionTargetGlobalInt Target(byte vehicle, GeodeticPosition place, PositionTargetTypemask mask)
        => new()
        {
            TargetSystem = vehicle,
            TargetComponent = AutopilotAddress.ComponentId,
            CoordinateFrame = MavFrame.GlobalInt,
            TypeMask = mask,
            LatInt = DegE7(place.Latitude.Radians),
            LonInt = DegE7(place.Longitude.Radians),
            Alt = (float)place.AltitudeAmslMetres,
        };

    private void Send<T>(in T message)
        where T : struct, IMavlinkMessage
        => _outbox.Enqueue(MavlinkFrame.Create(message, SystemId, ComponentId, _sequence++));

    private static int DegE7(double radians) => (int)Math.Round(radians * 1e7 / NedMath.RadiansPerDegree);
}
