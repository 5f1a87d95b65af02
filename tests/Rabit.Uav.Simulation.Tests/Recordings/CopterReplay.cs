using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Uav.Simulation.Tests.Recordings;

/// <summary>
/// Does to the simulated Copter what was done to the real one in a recording, at the same times: the companion's frames
/// over the link, the ground station and the pilot by the script of the world on their own link, the simulator's faults
/// by the script too.
/// </summary>
internal sealed class CopterReplay : IDisposable
{
    // What is watched in the recordings, at their rates.
    private static readonly (int Message, double Hertz)[] Streams =
        [(Heartbeat.MavlinkId, 5), (ExtendedSysState.MavlinkId, 5), (BatteryStatus.MavlinkId, 2),
            (SysStatus.MavlinkId, 2), (EkfStatusReport.MavlinkId, 2), (FenceStatus.MavlinkId, 2)];

    // Above home, the real one turns to the heading that it had at the start before it lands; the model leaves that
    // out.
    private const double TurnMilliseconds = 5500;

    // The recorded ground station sends its heartbeats 0.3 s after the full second, the simulated one at it.
    private const double BeginsAfter = 9.7;

    private readonly Recording _recording;
    private readonly double _offset;
    private readonly Ground _ground;

    private CopterReplay(Recording recording, double positionAfter)
    {
        _recording = recording;
        _offset = positionAfter > 0 ? 0 : BeginsAfter;
        _ground = new Ground(Options(positionAfter));
    }

    public IReadOnlyList<(TimeSpan Time, MavlinkFrame Frame)> Frames => _ground.Frames;

    /// <summary>HEARTBEAT, where it changes: mode, armed or not, MAV_STATE.</summary>
    public List<(double Time, string State)> ModeReports => Changes(
        _ground.All<Heartbeat>().Where(h => h.Message.Autopilot == MavAutopilot.Ardupilotmega)
            .Select(h => (h.Time, StateOf(h.Message))));

    public List<(double Time, string State)> LandedStates => Changes(
        _ground.All<ExtendedSysState>().Select(
            s => (s.Time, s.Message.LandedState.ToString().ToUpperInvariant())));

    public IEnumerable<(double Time, string Text)> Texts
        => _ground.All<Statustext>().Where(t => t.Time.TotalSeconds >= _offset)
            .Select(t => (t.Time.TotalSeconds - _offset, t.Message.Text.ToString()));

    public IEnumerable<string> Acknowledgements
        => _ground.All<CommandAck>().Where(a => a.Message.TargetComponent == 191).Select(
            a => ((int)a.Message.Command).ToString(CultureInfo.InvariantCulture) + " "
                + a.Message.Result.ToString().ToUpperInvariant());

    /// <param name="recording">What was done.</param>
    /// <param name="positionAfter">
    /// When the real one knew its position; 0: before the recording begins.
    /// </param>
    public static CopterReplay Fly(Recording recording, double positionAfter = 0)
    {
        var replay = new CopterReplay(recording, positionAfter);
        replay.Run();
        return replay;
    }

    public void Dispose() => _ground.Dispose();

    private void Run()
    {
        if (_offset > 0)
            _ground.Run(_offset - 1);
        foreach ((int message, double hertz) in Streams)
            _ground.Stream(message, hertz);
        var sent = _recording.CompanionFrames
            .Select(f => (f.Time.TotalSeconds, Action: (Action)(() => SendAgain(f.Frame)))).ToList();
        sent.AddRange(_recording.ParametersSet.Where(p => !IsOfSimulator(p.Name))
            .Select(p => (p.Time, (Action)(() => Set(p.Name, p.Value)))));
        sent.AddRange(_recording.Actions.Where(a => a.TryGetProperty("ch5", out _))
            .Select(a => (Recording.Time(a), (Action)(() => Switch(a.GetProperty("ch5").GetInt32())))));
        sent.AddRange(_recording.Actions.Where(a => a.TryGetProperty("channels", out _))
            .Select(a => (Recording.Time(a), (Action)(() => Switch(a.GetProperty("channels")[4].GetInt32())))));
        foreach ((double time, Action action) in sent.OrderBy(s => s.TotalSeconds))
        {
            double wait = time + _offset - _ground.Now.TotalSeconds;
            if (wait > 0)
                _ground.Run(wait);
            action();
        }

        _ground.Run(Math.Max(0.1, _recording.Seconds + _offset - _ground.Now.TotalSeconds));
    }

    private SimulationOptions Options(double positionAfter)
    {
        JsonElement home = _recording.Home;
        Dictionary<string, double> parameters = _recording.StartParameters.ToDictionary(p => p.Name, p => p.Value);
        var known = new ParameterStore();
        parameters["RTL_LOIT_TIME"] += TurnMilliseconds;
        return new SimulationOptions
        {
            Home = GeodeticPosition.FromDegrees(
                home.GetProperty("lat").GetDouble(), home.GetProperty("lon").GetDouble(),
                home.GetProperty("alt_m").GetDouble()),
            PositionAfter = TimeSpan.FromSeconds(positionAfter > 0 ? positionAfter : 5),
            BootedBefore = TimeSpan.FromSeconds(positionAfter > 0 ? 0 : 30),
            TelemetryLatency = TimeSpan.Zero,
            WindMetresPerSecond = parameters.TryGetValue("SIM_WIND_SPD", out double wind) ? wind : 0,
            WindFrom = parameters.TryGetValue("SIM_WIND_DIR", out double from) ? Angle.FromDegrees(from) : null,
            HasGroundStation = true,
            Parameters = parameters.Where(p => known.Contains(p.Key)).ToDictionary(p => p.Key, p => p.Value),
            Faults = Faults().ToArray(),
        };
    }

    private IEnumerable<ScriptedFault> Faults()
    {
        foreach (JsonElement action in _recording.Actions.Where(a => a.GetProperty("by").GetString() == "gcs"))
        {
            ScriptedFaultKind kind = KindOf(action);
            if (kind == ScriptedFaultKind.None)
                continue;
            yield return new ScriptedFault
            {
                Kind = kind,
                At = At(Recording.Time(action)),
                Duration = kind == ScriptedFaultKind.GroundStationSilent
                    ? EndOf(action, "HEARTBEAT again")
                    : TimeSpan.Zero,
                Value = kind == ScriptedFaultKind.PilotMode ? action.GetProperty("params")[1].GetDouble() : 0,
                Place = kind == ScriptedFaultKind.OtherCommander && action.TryGetProperty("params", out JsonElement to)
                    ? PlaceOf(to)
                    : null,
            };
        }

        (double Time, string Name, double Value)[] set = _recording.ParametersSet.ToArray();
        for (int index = 0; index < set.Length; index++)
        {
            (double time, string name, double value) = set[index];
            ScriptedFaultKind kind = KindOf(name, value);
            double end = set.Skip(index + 1).Where(s => s.Name == name).Select(s => s.Time).DefaultIfEmpty(0).First();
            if (kind == ScriptedFaultKind.None || time < 0)
                continue;
            yield return new ScriptedFault
            {
                Kind = kind,
                At = At(time),
                Duration = end > 0 ? TimeSpan.FromSeconds(end - time) : TimeSpan.Zero,
                Value = kind == ScriptedFaultKind.GpsGlitch ? value * 111_200 : value,
            };
        }
    }

    private static ScriptedFaultKind KindOf(JsonElement action) => action.GetProperty("action").GetString() switch
    {
        "HEARTBEAT stops" => ScriptedFaultKind.GroundStationSilent,
        "SET_POSITION_TARGET_GLOBAL_INT velocity 0" => ScriptedFaultKind.OtherCommander,
        "COMMAND_INT" => ScriptedFaultKind.OtherCommander,
        "COMMAND_LONG" when action.GetProperty("command").GetInt32() == (int)MavCmd.DoSetMode
            => ScriptedFaultKind.PilotMode,
        _ => ScriptedFaultKind.None,
    };

    private static ScriptedFaultKind KindOf(string parameter, double value) => parameter switch
    {
        "SIM_BATT_VOLTAGE" => ScriptedFaultKind.BatteryVolts,
        "SIM_RC_FAIL" when value > 0 => ScriptedFaultKind.RcLost,
        "SIM_GPS1_GLTCH_X" when value > 0 => ScriptedFaultKind.GpsGlitch,
        "SIM_GPS1_ENABLE" when value <= 0 => ScriptedFaultKind.GpsLost,
        _ => ScriptedFaultKind.None,
    };

    private static bool IsOfSimulator(string parameter) => parameter.StartsWith("SIM_", StringComparison.Ordinal);

    private static string StateOf(in Heartbeat heartbeat)
    {
        bool isArmed = (heartbeat.BaseMode & MavModeFlag.SafetyArmed) != 0;
        string mode = CopterModes.NameOf((CopterMode)heartbeat.CustomMode);
        return $"{mode} {(isArmed ? "armed" : "disarmed")} {(int)heartbeat.SystemStatus}";
    }

    private TimeSpan At(double time) => TimeSpan.FromSeconds(time + _offset);

    private TimeSpan EndOf(JsonElement action, string what)
    {
        double begin = Recording.Time(action);
        double end = _recording.Actions.Where(a => a.GetProperty("action").GetString() == what)
            .Select(Recording.Time).First(t => t > begin);
        return TimeSpan.FromSeconds(end - begin);
    }

    private NedPosition PlaceOf(JsonElement values)
    {
        JsonElement home = _recording.Home;
        double altitude = home.GetProperty("alt_m").GetDouble();
        var origin = GeodeticPosition.FromDegrees(
            home.GetProperty("lat").GetDouble(), home.GetProperty("lon").GetDouble(), altitude);
        return NedPosition.Origin + new WorldFrame(origin).ToWorld(GeodeticPosition.FromDegrees(
            values[4].GetDouble() * 1e-7, values[5].GetDouble() * 1e-7, altitude + values[6].GetDouble()));
    }

    private void SendAgain(in MavlinkFrame frame)
    {
        byte[] bytes = new byte[frame.WireLength];
        frame.WriteTo(bytes);
        _ground.Link.Write(bytes, 0, bytes.Length);
    }

    private void Set(string name, double value) => _ground.Send(
        new ParamSet { TargetSystem = 1, TargetComponent = 1, ParamId = new Text16(name), ParamValue = (float)value });

    private void Switch(int pulse) => _ground.Send(
        new RcChannelsOverride { TargetSystem = 1, TargetComponent = 1, Chan5Raw = (ushort)pulse });

    private List<(double Time, string State)> Changes(IEnumerable<(TimeSpan Time, string State)> reports)
    {
        var changes = new List<(double Time, string State)>();
        foreach ((TimeSpan time, string state) in reports.Where(r => r.Time.TotalSeconds >= _offset - 0.3))
        {
            if (changes.Count == 0 || changes[changes.Count - 1].State != state)
                changes.Add((time.TotalSeconds - _offset, state));
        }

        return changes;
    }
}
