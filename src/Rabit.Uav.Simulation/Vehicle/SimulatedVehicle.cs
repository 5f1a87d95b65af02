using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The vehicle without its link: body, battery, camera mount, sensors and autopilot, in steps of 10 ms. Not for two
/// threads at a time.
/// </summary>
internal sealed class SimulatedVehicle : IFrameSink
{
    public const double StepSeconds = 0.01;

    // Drawn by a quadrotor of about 2 kg: hovering, against the air, climbing, and by what is always on.
    private const double HoverWatts = 180;
    private const double DragWattsPerCube = 0.05;
    private const double ClimbWattsPerSpeed = 20;
    private const double IdleWatts = 25;
    private const double ElectronicsWatts = 8;

    private const long TicksPerMicrosecond = 10;
    private static readonly TimeSpan HeartbeatEvery = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan TimesyncEvery = TimeSpan.FromSeconds(10);

    private readonly SimulationOptions _options;
    private readonly TruthHistory _history;
    private readonly TruthRecorder _recorder;
    private readonly FaultScript _script;
    private readonly NavigationErrors _errors;
    private readonly BootClock _clock;
    private readonly AutopilotAddress _address;
    private readonly TelemetrySender _telemetry;
    private readonly StreamSchedule _streams = new();
    private readonly ParameterService _parameters;
    private readonly FrameDispatcher _dispatcher;
    private readonly Queue<MavlinkFrame> _outbox = new();
    private readonly Action<int> _sendMessage;
    private TimeSpan _time;
    private TimeSpan _nextHeartbeat;
    private TimeSpan _nextTimesync = TimesyncEvery;
    private ulong _utcMicroseconds;
    private byte _sequence;

    public SimulatedVehicle(SimulationOptions options, WorldFrame frame, TruthHistory history, TruthRecorder recorder)
    {
        _options = options;
        _history = history;
        _recorder = recorder;
        _script = new FaultScript(options.Faults);
        _errors = new NavigationErrors(options.Seed, StepSeconds);
        Body = new Multirotor { Yaw = options.Heading.Radians };
        Parameters = new ParameterStore();
        Pack = new Battery(Parameters.BatteryCapacity.Value / 1000, options.BatteryRemaining);

        var constants = new SimulationRandom(options.Seed, "vehicle constants");
        _clock = new BootClock(
            options.BootedBefore ?? TimeSpan.FromSeconds(constants.Uniform(20, 80)),
            options.ClockDriftPpm ?? constants.ModestNormal(20));
        double fromRadians = options.WindFrom?.Radians ?? constants.Uniform(-Math.PI, Math.PI);
        Air = new WindField(
            new SimulationRandom(options.Seed, "wind"), options.WindMetresPerSecond, fromRadians, StepSeconds);

        Controller = new FlightController(Parameters, Say) { BatteryVolts = Pack.Volts };
        Controller.Situation.StepSeconds = StepSeconds;
        _address = new AutopilotAddress(Parameters);
        _telemetry = new TelemetrySender(Controller, frame, constants.Next(), this);
        _sendMessage = _telemetry.Send;
        _parameters = new ParameterService(Parameters, this);
        var targets = new TargetReader(Controller, _telemetry, frame);
        var commands = new CommandHandler(Controller, targets, _streams, _telemetry, Mount, this);
        _dispatcher = new FrameDispatcher(Controller, commands, targets, _parameters, _streams, _address, this);
        Controller.Armed = SetHome;
    }

    public Multirotor Body { get; }

    public Battery Pack { get; }

    public Gimbal Mount { get; } = new();

    public WindField Air { get; }

    public ParameterStore Parameters { get; }

    public FlightController Controller { get; }

    /// <summary>Whether a scripted fault makes it deaf and dumb now.</summary>
    public bool IsSilent => _script.IsOn(ScriptedFaultKind.LinkSilent, _time);

    /// <summary>What it has to send.</summary>
    public bool TryTakeFrame(out MavlinkFrame frame)
    {
        frame = default;
        if (_outbox.Count == 0)
            return false;
        frame = _outbox.Dequeue();
        return true;
    }

    /// <summary>Takes a frame that has come.</summary>
    /// <param name="frame">One that a reader has checked.</param>
    /// <param name="time">When, by the clock of the run.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan time)
    {
        Observe(utc: null);
        _dispatcher.Handle(frame, _clock.Nanoseconds(time));
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
        Mount.Step(StepSeconds);
        Feel(time);

        MotionCommand command = Controller.Step();
        if (Pack.IsEmpty)
            command.Motors = MotorState.Off;
        Body.Step(command, Air.Velocity, StepSeconds);
        Pack.Step(Watts(command.Motors), StepSeconds);
        Record();
        Observe(utc);
        SendWhatIsDue();
    }

    /// <summary>Puts a message into the outbox.</summary>
    public void Send<T>(in T message)
        where T : struct, IMavlinkMessage
        => _outbox.Enqueue(MavlinkFrame.Create(message, _address.SystemId, AutopilotAddress.ComponentId, _sequence++));

    // What the autopilot steers by: the errors that are slow are in it, so that it really flies by its estimated
    // position.
    private void Feel(TimeSpan time)
    {
        FlightSituation situation = Controller.Situation;
        situation.Time = time;
        situation.Position = Body.Position.Plus(_errors.SteadyPosition);
        situation.Velocity = Body.Velocity;
        situation.Yaw = Body.Yaw;
        situation.TouchesGround = Body.IsOnGround;
        Controller.BatteryVolts = Pack.Volts;
        Controller.Failsafes.ConsumedAmpereHours = Pack.ConsumedAmpereHours;
        if (Controller.HasPosition || time < _options.PositionAfter)
            return;

        Controller.HasPosition = true;
        situation.Home = situation.Position;
        _telemetry.Origin = _telemetry.Home = situation.Position;
        Say(MavSeverity.Info, "EKF3 IMU0 is using GPS");
        Say(MavSeverity.Info, "EKF3 IMU1 is using GPS");
    }

    private void SetHome()
    {
        if (!Controller.HasPosition)
            return;
        FlightSituation situation = Controller.Situation;
        situation.Home = situation.Position;
        _telemetry.Home = situation.Position;
        _telemetry.Send(HomePosition.MavlinkId);
        _telemetry.Send(GpsGlobalOrigin.MavlinkId);
    }

    private double Watts(MotorState motors)
    {
        if (motors == MotorState.Off)
            return ElectronicsWatts;
        if (motors == MotorState.Idle)
            return ElectronicsWatts + IdleWatts;
        NedVector air = Body.Velocity.Minus(Air.Velocity);
        double speed = air.HorizontalLength();
        double climb = Math.Max(-0.5 * HoverWatts, -Body.Velocity.Down * ClimbWattsPerSpeed);
        return ElectronicsWatts + HoverWatts + (DragWattsPerCube * speed * speed * speed) + climb;
    }

    private void Record()
    {
        var pose = new TruePose
        {
            Time = _time,
            Position = NedPosition.Origin + Body.Position,
            VelocityNed = Body.Velocity,
            Attitude = EulerAngles.FromRadians(Body.Roll, Body.Pitch, Body.Yaw),
            CameraPitch = Angle.FromRadians(Mount.Pitch),
            CameraYaw = Angle.FromRadians(Mount.Yaw),
        };
        _history.Add(pose);
        _recorder.Record(pose, Controller.IsArmed, Controller.Mode, Pack.Remaining, Body.TouchdownSpeed);
    }

    // Answers between two steps report the last one.
    private void Observe(DateTimeOffset? utc)
    {
        if (utc is { } known)
            _utcMicroseconds = Controller.HasPosition
                ? (ulong)((known - DateTimeOffset.FromUnixTimeSeconds(0)).Ticks / TicksPerMicrosecond)
                : 0;
        EulerAngles errors = _errors.EstimatedAttitude;
        _telemetry.Update(new AutopilotState
        {
            Time = _time,
            BootMicroseconds = _clock.Microseconds(_time),
            UtcMicroseconds = _utcMicroseconds,
            HasPosition = Controller.HasPosition,
            Position = Body.Position.Plus(_errors.EstimatedPosition),
            Velocity = Body.Velocity.Plus(_errors.EstimatedVelocity),
            Attitude = EulerAngles.FromRadians(
                NedMath.Wrapped(Body.Roll + errors.Roll.Radians),
                Body.Pitch + errors.Pitch.Radians,
                NedMath.Wrapped(Body.Yaw + errors.Yaw.Radians)),
            Rates = Body.Rates,
            AirVelocity = Body.Velocity.Minus(Air.Velocity),
            CameraPitch = Mount.Pitch,
            CameraYaw = Mount.Yaw,
            BatteryVolts = Pack.Volts,
            BatteryAmperes = Pack.Amperes,
            BatteryRemaining = Pack.Remaining,
            ConsumedAmpereHours = Pack.ConsumedAmpereHours,
            ConsumedJoules = Pack.ConsumedJoules,
        });
    }

    private void SendWhatIsDue()
    {
        if (_time >= _nextHeartbeat)
        {
            _nextHeartbeat += HeartbeatEvery;
            _telemetry.Send(Heartbeat.MavlinkId);
        }

        if (_time >= _nextTimesync)
        {
            // ArduPilot asks too, and marks its questions with its system id.
            _nextTimesync += TimesyncEvery;
            Send(new Timesync { Ts1 = _clock.Nanoseconds(_time) + _address.SystemId });
        }

        _streams.Send(_time, _sendMessage);
        _parameters.Step();
    }

    private void Say(MavSeverity severity, string text)
        => Send(new Statustext { Severity = severity, Text = new Text50(text) });
}
