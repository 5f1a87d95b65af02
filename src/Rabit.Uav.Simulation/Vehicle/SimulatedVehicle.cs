using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The vehicle without its link: body, battery, camera mount, sensors and autopilot, in steps of 10 ms. Not for two
/// threads at a time.
/// </summary>
internal sealed class SimulatedVehicle : ILinkSink
{
    public const double StepSeconds = 0.01;

    private const long TicksPerMicrosecond = 10;

    // From the reboot command to the first heartbeat: ap-fence-reboot in tests/data/autopilots.
    private static readonly TimeSpan BootTime = TimeSpan.OfSeconds(0.9);

    private readonly SimulationOptions _options;
    private readonly TruthHistory _history;
    private readonly TruthRecorder _recorder;
    private readonly FaultScript _script;
    private readonly ReportFaults _reports;
    private readonly NavigationErrors _errors;
    private readonly SecondLink _secondLink;
    private readonly double _driftPpm;
    private BootClock _clock;
    private TimeSpan _positionAfter;
    private TimeSpan _bootedAt = TimeSpan.MinValue;
    private bool _handlesSecondLink;
    private readonly Queue<MavlinkFrame>[] _outboxes;
    private readonly byte[] _sequences;
    private TimeSpan _time;
    private ulong _utcMicroseconds;

    /// <param name="options">Of the world.</param>
    /// <param name="frame">Of the world.</param>
    /// <param name="history">Keeps where it was, for the camera.</param>
    /// <param name="recorder">Keeps the truth.</param>
    /// <param name="linkCount">How many links are read; what goes out over further ones is not kept.</param>
    public SimulatedVehicle(
        SimulationOptions options, WorldFrame frame, TruthHistory history, TruthRecorder recorder, int linkCount = 1)
    {
        _outboxes = new Queue<MavlinkFrame>[linkCount];
        for (int link = 0; link < linkCount; link++)
            _outboxes[link] = new Queue<MavlinkFrame>();
        LinkCount = Math.Max(linkCount, options.HasGroundStation ? SecondLink.Number + 1 : 1);
        _sequences = new byte[LinkCount];
        _options = options;
        _history = history;
        _recorder = recorder;
        _script = new FaultScript(options.Faults);
        _reports = new ReportFaults(_script);
        _secondLink = new SecondLink(options, frame, _script);
        _positionAfter = options.PositionAfter;
        _errors = new NavigationErrors(options.Seed, StepSeconds, options.BarometerDriftMetres);
        Body = new Multirotor { Yaw = options.Heading.Radians };
        (double pitch, double yaw) = (options.Camera.Pitch.Radians, options.Camera.Yaw.Radians);
        GimbalFrame frameOfMount = options.Camera.GimbalFrame;
        Mount = frameOfMount == GimbalFrame.Body
            ? new Gimbal(pitch, yaw)
            : new StabilisedGimbal(options.Seed, frameOfMount, options.Heading.Radians, StepSeconds, pitch, yaw);

        var constants = new SimulationRandom(options.Seed, "vehicle constants");
        TimeSpan bootedBefore = options.BootedBefore ?? TimeSpan.OfSeconds(constants.Uniform(20, 80));
        _driftPpm = options.ClockDriftPpm ?? constants.ModestNormal(20);
        _clock = new BootClock(bootedBefore, _driftPpm);
        double fromRadians = options.WindFrom?.Radians ?? constants.Uniform(-Math.PI, Math.PI);
        Air = new WindField(
            new SimulationRandom(options.Seed, "wind"), options.WindMetresPerSecond, fromRadians, StepSeconds);

        ulong uid = constants.Next();
        Autopilot = options.Autopilot == SimulatedAutopilot.Px4
            ? new Px4Autopilot(
                new Px4Parameters(), frame, uid, Mount, StepSeconds, new SimulationRandom(options.Seed, "stack"), this)
            : new ArdupilotAutopilot(
                new ParameterStore(options.HasNewerParameterNames), frame, uid, Mount, StepSeconds, this);
        Autopilot.SetParameter(NameOfSystemId(options), options.SystemId);
        if (options.IsPrepared)
            PreparedParameters.ApplyTo(Autopilot, options.Autopilot);
        foreach (KeyValuePair<string, double> parameter in options.Parameters)
            Autopilot.SetParameter(parameter.Key, (float)parameter.Value);
        Pack = new Battery(
            Autopilot.BatteryCapacityAmpereHours, options.BatteryRemaining, options.BatteryCapacityFraction);
    }

    public Multirotor Body { get; }

    public Battery Pack { get; }

    public Gimbal Mount { get; }

    public WindField Air { get; }

    public RemoteControl Radio { get; } = new();

    /// <summary>Another one after a reboot.</summary>
    public IVehicleAutopilot Autopilot { get; private set; }

    /// <summary>Whether a scripted fault makes it deaf and dumb now.</summary>
    public bool IsSilent => _script.IsOn(ScriptedFaultKind.LinkSilent, _time);

    /// <summary>Whether the autopilot has been switched on and does not take or send anything yet.</summary>
    public bool IsBooting => _bootedAt != TimeSpan.MinValue && _time - _bootedAt < BootTime;

    /// <summary>How many links it has, with that of the ground station.</summary>
    public int LinkCount { get; }

    /// <summary>What it has to send over a link.</summary>
    public bool TryTakeFrame(out MavlinkFrame frame, int link = 0)
    {
        frame = default;
        if (_outboxes[link].Count == 0)
            return false;
        frame = _outboxes[link].Dequeue();
        return true;
    }

    /// <summary>Takes a frame that has come.</summary>
    /// <param name="frame">One that a reader has checked.</param>
    /// <param name="time">When, by the clock of the run.</param>
    /// <param name="link">Over which link.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan time, int link = 0)
    {
        Observe(utc: null);
        Autopilot.Handle(frame, _clock.Nanoseconds(time), link);
        if (Autopilot.WantsReboot)
            Reboot(staysArmed: false);
    }

    /// <summary>The autopilot starts again: its clock, its estimate and what it was asked for are gone.</summary>
    /// <param name="staysArmed">Whether it is armed as before, as after a reset by its watchdog.</param>
    public void Reboot(bool staysArmed)
    {
        Autopilot = Autopilot.Restarted(_time, BootTime, staysArmed);
        _clock = BootClock.StartedAt(_time, _driftPpm);
        _positionAfter = _time + _options.PositionAfter;
        _bootedAt = _time;
        Array.Clear(_sequences, 0, _sequences.Length);
    }

    /// <summary>One step.</summary>
    /// <param name="time">Its end, by the clock of the run.</param>
    /// <param name="utc">Its end, as a GPS would report it.</param>
    public void Step(TimeSpan time, DateTimeOffset utc)
    {
        _time = time;
        _script.Apply(time, this);
        Air.Step();
        _errors.Step();
        Mount.Step(
            EulerAngles.FromRadians(Body.Roll, Body.Pitch, Body.Yaw), Body.Rates, _errors.EstimatedAttitude.Yaw,
            StepSeconds);
        HandleSecondLink();
        MotionCommand command = Autopilot.Step(Senses());
        if (Pack.IsEmpty)
            command.Motors = MotorState.Off;
        Body.Step(command, Air.Velocity, StepSeconds);
        Pack.Step(PowerDraw.Watts(command.Motors, Body.Velocity, Air.Velocity), StepSeconds);
        Record();
        Observe(utc);
        Autopilot.SendWhatIsDue(time, _clock.Nanoseconds(time));
    }

    /// <summary>
    /// Puts a message into the outbox. Where what came over the second link is answered, the answer goes there.
    /// </summary>
    public void Send<T>(in T message)
        where T : struct, IMavlinkMessage
    {
        if (DoesNotSend<T>())
            return;
        var frame = MavlinkFrame.Create(message, Autopilot.SystemId, AutopilotAddress.ComponentId, _sequences[0]++);
        if (!_handlesSecondLink || !IsForSecondLink(frame))
            _outboxes[0].Enqueue(frame);
    }

    /// <summary>Sends a message over one link; what goes to the ground station's own link ends there.</summary>
    public void Send<T>(int link, in T message)
        where T : struct, IMavlinkMessage
    {
        if (DoesNotSend<T>() || link >= _outboxes.Length)
            return;
        _outboxes[link].Enqueue(MavlinkFrame.Create(
            message, Autopilot.SystemId, AutopilotAddress.ComponentId, _sequences[link]++));
    }

    /// <summary>Sends a frame that a protocol server made.</summary>
    public void SendNumbered(in MavlinkFrame frame)
    {
        if (!IsBooting && (!_handlesSecondLink || !IsForSecondLink(frame)))
            _outboxes[0].Enqueue(frame.WithSequence(_sequences[0]++));
    }

    /// <summary>Sends a frame that a protocol server made over one link.</summary>
    public void SendNumbered(int link, MavlinkFrame frame)
    {
        if (!IsBooting && link < _outboxes.Length)
            _outboxes[link].Enqueue(frame.WithSequence(_sequences[link]++));
    }

    /// <summary>Passes on a frame of the second link as it is.</summary>
    public void Forward(in MavlinkFrame frame)
    {
        if (!IsBooting)
            _outboxes[0].Enqueue(frame);
    }

    private static string NameOfSystemId(SimulationOptions options)
        => options.Autopilot == SimulatedAutopilot.Px4 ? "MAV_SYS_ID"
            : options.HasNewerParameterNames ? "MAV_SYSID" : "SYSID_THISMAV";

    private bool DoesNotSend<T>()
        => IsBooting || (IsAttitude<T>() && _script.IsOn(ScriptedFaultKind.AttitudeSilent, _time));

    private static bool IsAttitude<T>() => typeof(T) == typeof(Attitude) || typeof(T) == typeof(AttitudeQuaternion);

    private static bool IsForSecondLink(in MavlinkFrame frame)
        => MavlinkDialect.All.TryGetMessage(frame.MessageId, out MavlinkMessageInfo info)
            && frame.TargetSystem(info) == SecondLink.SystemId;

    private void HandleSecondLink()
    {
        _secondLink.Step(_time, Autopilot.SystemId);
        while (_secondLink.TryTakeFrame(out MavlinkFrame frame))
        {
            if (IsBooting)
                continue;
            _handlesSecondLink = true;
            Autopilot.Handle(frame, _clock.Nanoseconds(_time), SecondLink.Number);
            _handlesSecondLink = false;
        }
    }

    private bool HasGps => _time >= _positionAfter && !_script.IsOn(ScriptedFaultKind.GpsLost, _time);

    private VehicleSenses Senses() => new()
    {
        Time = _time,
        Position = Body.Position.Plus(_errors.SteadyPosition),
        Velocity = Body.Velocity,
        Yaw = Body.Yaw,
        TouchesGround = Body.IsOnGround,
        HasGps = HasGps,
        IsGpsGlitching = _script.IsOn(ScriptedFaultKind.GpsGlitch, _time),
        IsEstimatorBad = _script.IsOn(ScriptedFaultKind.EkfFailsafe, _time),
        IsRadioReceived = Radio.IsReceived,
        ModeOfSwitch = Radio.ModeOfSwitch,
        SwitchCount = Radio.SwitchCount,
        BatteryVolts = Pack.MeasuredVolts,
        BatteryRemaining = Pack.Reported,
        ConsumedAmpereHours = Pack.ConsumedAmpereHours,
    };

    private void Record()
    {
        GimbalAngles camera = Mount.Angles;
        var pose = new TruePose
        {
            Time = _time,
            Position = NedPosition.Origin + Body.Position,
            VelocityNed = Body.Velocity,
            Attitude = EulerAngles.FromRadians(Body.Roll, Body.Pitch, Body.Yaw),
            CameraFrame = camera.Frame,
            CameraPitch = Angle.FromRadians(camera.Pitch),
            CameraRoll = Angle.FromRadians(camera.Roll),
            CameraYaw = Angle.FromRadians(camera.Yaw),
        };
        _history.Add(pose);
        _recorder.Record(
            pose, Autopilot.IsArmed, Autopilot.CustomMode, Autopilot.ModeName, Pack.Remaining, Body.TouchdownSpeed);
    }

    // Answers between two steps report the last one.
    private void Observe(DateTimeOffset? utc)
    {
        if (utc is { } known)
            _utcMicroseconds = Autopilot.HasPosition
                ? (ulong)((known - DateTimeOffset.FromUnixTimeSeconds(0)).Ticks / TicksPerMicrosecond)
                : 0;
        EulerAngles errors = _errors.EstimatedAttitude;
        var state = new AutopilotState
        {
            Time = _time,
            BootMicroseconds = _clock.Microseconds(_time),
            UtcMicroseconds = _utcMicroseconds,
            HasPosition = Autopilot.HasPosition,
            HasGps = HasGps,
            BarometerErrorDown = _errors.BarometerDown,
            GpsErrorNorth = _script.ValueOf(ScriptedFaultKind.GpsGlitch, _time) ?? 0,
            Position = Body.Position.Plus(_errors.EstimatedPosition),
            Velocity = Body.Velocity.Plus(_errors.EstimatedVelocity),
            Attitude = EulerAngles.FromRadians(
                NedMath.Wrapped(Body.Roll + errors.Roll.Radians),
                Body.Pitch + errors.Pitch.Radians,
                NedMath.Wrapped(Body.Yaw + errors.Yaw.Radians)),
            Rates = Body.Rates,
            AirVelocity = Body.Velocity.Minus(Air.Velocity),
            Gimbal = Mount.Reported,
            BatteryVolts = Pack.MeasuredVolts,
            BatteryAmperes = Pack.Amperes,
            BatteryRemaining = Pack.Reported,
            ConsumedAmpereHours = Pack.ConsumedAmpereHours,
            ConsumedJoules = Pack.ConsumedJoules,
            TrueDown = Body.Position.Down,
        };
        _reports.Apply(_time, ref state);
        Autopilot.Observe(state);
    }
}
