using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>
/// Does to the simulated PX4 what was done to the real one in a recorded flight, at the same times: what companion,
/// ground station and pilot sent, parameters, the battery. The companion is on link 0, the ground station on link 1.
/// </summary>
internal sealed class Px4Replay
{
    private const double BeforeStart = 20;
    private const byte Companion = 191;
    private const byte Ground = 255;

    private readonly Px4Recording _recording;
    private readonly Px4Flyer _flyer;
    private readonly Px4Path _path;
    private readonly Px4Pilot _pilot = new();
    private readonly List<(double Time, string State)> _states = [];
    private readonly Queue<JsonElement> _actions;
    private readonly Queue<(double Time, string Name, double Value)> _parameters;
    private double _drainSeconds;
    private double? _armedAt;
    private double _nextHeartbeat;
    private double _nextGround = -BeforeStart;
    private bool _groundIsSilent;
    private bool _groundOnLinkOfCompanion;

    public Px4Replay(Px4Recording recording)
    {
        _recording = recording;
        _flyer = new Px4Flyer(recording.Home, -BeforeStart);
        _path = new Px4Path(_flyer);
        _actions = new Queue<JsonElement>(recording.Actions);
        _parameters = new Queue<(double, string, double)>(recording.Parameters.OrderBy(p => p.Time));
        _flyer.Set("COM_OF_LOSS_T", 1);       // as in all these flights
        _flyer.Set("COM_LOW_BAT_ACT", 2);
        _flyer.Set("MPC_XY_CRUISE", 5);
        _nextHeartbeat = -BeforeStart;
    }

    /// <summary>Mode, base mode and status as HEARTBEAT says it, at each change.</summary>
    public IReadOnlyList<(double Time, string State)> States => _states;

    public IReadOnlyList<(double Time, MavlinkFrame Frame)> Frames(int link) => _flyer.Frames(link);

    /// <summary>Answers that differ from those recorded.</summary>
    public List<string> WrongAnswers { get; } = [];

    public SimulatedVehicle Vehicle => _flyer.Vehicle;

    /// <summary>Where it was, each 10 ms from the first record.</summary>
    public List<(double Time, TruePose Pose)> Poses { get; } = [];

    public Px4Replay Run()
    {
        string file = _recording.Root.GetProperty("file").GetString()!;
        bool isTexts = file.StartsWith("px4-texts", StringComparison.Ordinal);
        while (_flyer.Time < _recording.Duration)
        {
            // In px4-texts the ground station had gone: its loss was reported 0.5 s after the first record.
            if (isTexts)
                _groundIsSilent = _flyer.Time > -10.9;
            Act();
            _flyer.Step();
            Watch();
        }

        return this;
    }

    /// <summary>What heartbeats at the times of the recorded ones would have shown, at each change.</summary>
    public List<(double Time, string State)> StatesAtHeartbeats()
    {
        var seen = new List<(double Time, string State)>();
        double period = _recording.HeartbeatPeriod;
        double first = _recording.Modes.First().Time;
        for (double time = first; time < _recording.Duration; time += period)
        {
            string state = _states.Last(s => s.Time <= time).State;
            if (seen.Count == 0 || seen[seen.Count - 1].State != state)
                seen.Add((time, state));
        }

        return seen;
    }

    private void Act()
    {
        double time = _flyer.Time;
        while (_parameters.Count > 0 && _parameters.Peek().Time <= time)
            SetParameter(_parameters.Dequeue());
        while (_actions.Count > 0 && Px4Recording.TimeOf(_actions.Peek()) <= time)
            Do(_actions.Dequeue());
        if (time >= _nextHeartbeat)
        {
            _nextHeartbeat += 1;
            _flyer.Send(0, new Heartbeat { Type = MavType.OnboardController }, 1, Companion);
            if (_groundOnLinkOfCompanion)
                _flyer.Send(0, new Heartbeat { Type = MavType.Gcs }, Ground, 190);
        }

        if (time >= _nextGround && !_groundIsSilent)
        {
            _nextGround = time + 1;
            _flyer.Send(1, new Heartbeat { Type = MavType.Gcs }, Ground, 190);
        }

        _path.Step();
        _pilot.Step(_flyer);
        DrainBattery();
    }

    private void SetParameter((double Time, string Name, double Value) parameter)
    {
        if (parameter.Name == "SIM_BAT_DRAIN")
            _drainSeconds = parameter.Value;
        else if (parameter.Name is not ("SIM_BAT_MIN_PCT" or "MPC_TKO_RAMP_T"))
            _flyer.Set(parameter.Name, parameter.Value);
    }

    // PX4's simulated battery loses its charge within SIM_BAT_DRAIN; its estimate lags by some 10 s and stayed at 9 %.
    private void DrainBattery()
    {
        if (_drainSeconds <= 0)
            return;
        if (_flyer.Vehicle.Autopilot.IsArmed)
            _armedAt ??= _flyer.Time;
        else
            _armedAt = null;
        double armed = _armedAt is { } since ? Math.Max(0, _flyer.Time - since - 10) : 0;
        _flyer.Vehicle.Pack.Set(Math.Max(0.09, 1 - (armed / _drainSeconds)));
    }

    private void Do(JsonElement action)
    {
        bool isCompanion = action.GetProperty("by").GetString() == "companion";
        string what = action.GetProperty("action").GetString()!;
        switch (what)
        {
            case "COMMAND_LONG" or "COMMAND_INT": Command(action, isCompanion, what == "COMMAND_INT"); break;
            case "set-points start": _path.Start(); break;
            case "set-points stop": _path.Stop(); break;
            case "leg":
                _path.Fly(
                    action.GetProperty("bearing_deg").GetDouble(), action.GetProperty("length_m").GetDouble(),
                    action.GetProperty("speed_mps").GetDouble());
                break;
            case "HEARTBEAT stops": _groundIsSilent = true; break;
            case "HEARTBEAT again": (_groundIsSilent, _nextGround) = (false, _flyer.Time); break;
            case "MISSION_COUNT": _flyer.UploadFence(_recording.Root.GetProperty("fence")); break;
            default:
                if (what.StartsWith("phase 2", StringComparison.Ordinal))
                    _groundOnLinkOfCompanion = true;
                _pilot.Do(what, action, _flyer.Time);
                break;
        }
    }

    private void Command(JsonElement action, bool isCompanion, bool isInt)
    {
        int link = isCompanion ? 0 : 1;
        float[] p = action.GetProperty("params").EnumerateArray()
            .Select(v => v.ValueKind == JsonValueKind.Null ? float.NaN : v.GetSingle()).ToArray();
        var command = (MavCmd)action.GetProperty("command").GetInt32();
        (byte system, byte component) = isCompanion ? ((byte)1, Companion) : (Ground, (byte)190);
        if (isInt)
        {
            _flyer.Send(link, new CommandInt
            {
                TargetSystem = 1,
                TargetComponent = 1,
                Command = command,
                Frame = (MavFrame)(action.TryGetProperty("frame", out JsonElement frame) ? frame.GetInt32() : 0),
                Param1 = p[0],
                Param2 = p[1],
                Param3 = p[2],
                Param4 = p[3],
                X = (int)action.GetProperty("params")[4].GetDouble(),
                Y = (int)action.GetProperty("params")[5].GetDouble(),
                Z = p[6],
            }, system, component);
        }
        else
        {
            _flyer.Send(link, new CommandLong
            {
                TargetSystem = 1,
                TargetComponent = 1,
                Command = command,
                Param1 = p[0],
                Param2 = p[1],
                Param3 = p[2],
                Param4 = p[3],
                Param5 = p[4],
                Param6 = p[5],
                Param7 = p[6],
            }, system, component);
        }

        Compare(action, link, command);
    }

    private void Compare(JsonElement action, int link, MavCmd command)
    {
        if (action.GetProperty("ack").ValueKind == JsonValueKind.Null)
            return;
        var expected = (MavResult)action.GetProperty("ack").GetProperty("result").GetInt32();
        MavResult? answer = null;
        foreach ((double _, MavlinkFrame frame) in _flyer.Frames(link).Reverse().Take(50))
        {
            if (answer is null && frame.TryDecode(out CommandAck ack) && ack.Command == command)
                answer = ack.Result;
        }

        if (answer != expected)
            WrongAnswers.Add(FormattableString.Invariant(
                $"{Px4Recording.TimeOf(action)}: {action.GetProperty("what")}: {answer}, recorded {expected}"));
    }

    private void Watch()
    {
        Heartbeat heartbeat = _flyer.AskForHeartbeat();
        string mode = Px4ModeNames.NameOf((Px4Mode)heartbeat.CustomMode);
        string state = $"{mode} {(int)heartbeat.BaseMode} {(int)heartbeat.SystemStatus}";
        if (_states.Count == 0 || _states[_states.Count - 1].State != state)
            _states.Add((_flyer.Time, state));
        if (_flyer.Time >= 0)
            Poses.Add((_flyer.Time, _flyer.Pose));
    }
}
