using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>
/// An autopilot that answers commands as a test says, with a delay each way, beside an Autopilot Interface in virtual
/// time. It beats once a second and sends its position ten times.
/// </summary>
internal sealed class ScriptedAutopilot : IDisposable
{
    private const double Step = 0.01;

    private readonly List<(double Due, Action Act)> _due = [];
    private readonly List<(TimeSpan Time, MavlinkFrame Frame)> _received = [];
    private SetPositionTargetGlobalInt? _setPoint;
    private double _nextBeat;
    private double _nextPosition;
    private int _taken;
    private long _id;

    public ScriptedAutopilot(
        MavAutopilot make = MavAutopilot.Ardupilotmega, bool mayCommand = true, AutopilotOptions? options = null)
    {
        Make = make;
        Mode = make == MavAutopilot.Px4 ? 0x0003_0000u : (uint)CopterMode.Stabilize;
        options ??= new AutopilotOptions { RequestsRates = false };
        options.MayCommand = mayCommand;
        Rig = new AutopilotRig(options);
        Script = Accept;
    }

    public AutopilotRig Rig { get; }

    public MavAutopilot Make { get; set; }

    public MavType Type { get; set; } = MavType.Quadrotor;

    public uint Mode { get; set; }

    public bool IsArmed { get; set; }

    public bool Beats { get; set; } = true;

    public MavState Status { get; set; } = MavState.Active;

    /// <summary>Where it does not follow set-points.</summary>
    public double HeightMetres { get; set; } = 30;

    /// <summary>Whether its position is that of the last set-point.</summary>
    public bool FollowsSetPoints { get; set; }

    /// <summary>What it answers where its HEARTBEAT is asked for; null where it does not answer.</summary>
    public MavResult? ReportAnswer { get; set; } = MavResult.Accepted;

    /// <summary>How often it was asked for its HEARTBEAT.</summary>
    public int ReportRequests { get; private set; }

    /// <summary>One way.</summary>
    public double Latency { get; set; } = 0.02;

    /// <summary>What it answers to a command, and does; null for no answer.</summary>
    public Func<MavlinkFrame, MavCmd, MavResult?> Script { get; set; }

    public NedVector VelocityNed { get; set; }

    /// <summary>Commands and set-points that came, and when they were sent.</summary>
    public IReadOnlyList<(TimeSpan Time, MavlinkFrame Frame)> Received => _received;

    public IEnumerable<MavCmd> Commands
        => _received.Where(f => CommandOf(f.Frame) is not null).Select(f => CommandOf(f.Frame)!.Value);

    public IReadOnlyList<VehicleCommandResult> Answers => Rig.Peers.Answers;

    public CommandAuthorityState Authority => Rig.Authority.State;

    public static MavCmd? CommandOf(in MavlinkFrame frame) => frame.MessageId switch
    {
        CommandLong.MavlinkId => OutgoingSink.Decode<CommandLong>(frame).Command,
        CommandInt.MavlinkId => OutgoingSink.Decode<CommandInt>(frame).Command,
        _ => null,
    };

    public T Last<T>()
        where T : struct, IMavlinkMessage
        => OutgoingSink.Decode<T>(_received.Last(f => f.Frame.TryDecode(out T _)).Frame);

    /// <summary>Does what it is commanded, and acknowledges it.</summary>
    public MavResult? Accept(MavlinkFrame frame, MavCmd command)
    {
        switch (command)
        {
            case MavCmd.DoSetMode:
                CommandLong mode = OutgoingSink.Decode<CommandLong>(frame);
                Mode = Make == MavAutopilot.Px4
                    ? ((uint)mode.Param2 << 16) | ((uint)mode.Param3 << 24)
                    : (uint)mode.Param2;
                break;
            case MavCmd.NavTakeoff when Make == MavAutopilot.Px4:
                Mode = 0x0204_0000;
                break;
            case MavCmd.ComponentArmDisarm:
                IsArmed = OutgoingSink.Decode<CommandLong>(frame).Param1 > 0;
                break;
        }

        return MavResult.Accepted;
    }

    /// <summary>Gives a command, and says its id.</summary>
    public long Give(VehicleCommandKind kind, Func<VehicleCommand, VehicleCommand>? with = null)
    {
        var command = new VehicleCommand
        {
            Id = ++_id,
            Kind = kind,
            Latitude = Angle.FromRadians(0.7),
            Longitude = Angle.FromRadians(0.1),
            HeightAboveHomeMetres = 40,
            SpeedMetresPerSecond = double.NaN,
            Yaw = Angle.NaN,
            VelocityNed = new NedVector(3, 1, 0),
            Mode = "GUIDED",
        };
        Rig.Command(with is null ? command : with(command));
        return _id;
    }

    public VehicleCommandResult GiveAndRun(
        VehicleCommandKind kind, double seconds = 4, Func<VehicleCommand, VehicleCommand>? with = null)
    {
        long id = Give(kind, with);
        Run(seconds);
        return Answers.Single(a => a.Id == id);
    }

    /// <summary>Makes it ours: GUIDED, armed.</summary>
    public ScriptedAutopilot Armed()
    {
        Run(1.5);
        Assert(GiveAndRun(VehicleCommandKind.Arm).Outcome == VehicleCommandOutcome.Accepted);
        Run(2);
        return this;
    }

    public void Run(double seconds)
    {
        double end = Rig.Reactor.Now.TotalSeconds + seconds;
        while (Rig.Reactor.Now.TotalSeconds < end - (Step / 2))
        {
            Telemeter();
            Listen();
            Act();
            Rig.Run(Step);
        }

        Listen();
    }

    /// <summary>Sends something after the latency of the link.</summary>
    public void Say<T>(T message, double later = 0, byte component = AutopilotRig.Autopilot)
        where T : struct, IMavlinkMessage
        => Later(Latency + later, () => Rig.Send(message, component: component));

    public void Acknowledge(MavCmd command, MavResult result, double later = 0, byte system = 1, byte component = 191)
        => Say(
            new CommandAck { Command = command, Result = result, TargetSystem = system, TargetComponent = component },
            later);

    public void SayText(string text, MavSeverity severity = MavSeverity.Critical)
        => Say(new Statustext { Severity = severity, Text = new Text50(text) });

    /// <summary>Does something later.</summary>
    public void Later(double seconds, Action act) => _due.Add((Rig.Reactor.Now.TotalSeconds + seconds, act));

    /// <summary>Shows the mode at once, not only with the next heartbeat that is due.</summary>
    public void Beat(uint? mode = null) => Say(Heartbeat(mode ?? Mode));

    public void Dispose() => Rig.Dispose();

    private Heartbeat Heartbeat(uint mode) => new()
    {
        Type = Type,
        Autopilot = Make,
        BaseMode = MavModeFlag.CustomModeEnabled | (IsArmed ? MavModeFlag.SafetyArmed : 0),
        CustomMode = mode,
        SystemStatus = Status,
        MavlinkVersion = 3,
    };

    private void Telemeter()
    {
        double now = Rig.Reactor.Now.TotalSeconds;
        if (Beats && now >= _nextBeat)
        {
            _nextBeat = Math.Floor(now + 1e-6) + 1;
            Beat();
        }

        if (now < _nextPosition)
            return;
        _nextPosition = now + 0.1;
        SetPositionTargetGlobalInt? at = FollowsSetPoints ? _setPoint : null;
        int height = at is { } point ? (int)(point.Alt * 1000) : (int)(HeightMetres * 1000);
        Say(new GlobalPositionInt
        {
            TimeBootMs = (uint)(60_000 + (now * 1000)),
            Lat = at?.LatInt ?? 401_000_000,
            Lon = at?.LonInt ?? 57_000_000,
            Alt = 100_000 + height,
            RelativeAlt = height,
            Vx = (short)(VelocityNed.North * 100),
            Vy = (short)(VelocityNed.East * 100),
        });
    }

    private void Listen()
    {
        for (; _taken < Rig.Sink.Frames.Count; _taken++)
        {
            (TimeSpan time, MavlinkFrame frame) = Rig.Sink.Frames[_taken];
            if (CommandOf(frame) == MavCmd.RequestMessage)
            {
                Later(Latency, Report);
                continue;
            }

            if (frame.MessageId is CommandLong.MavlinkId or CommandInt.MavlinkId or SetPositionTargetLocalNed.MavlinkId
                or SetPositionTargetGlobalInt.MavlinkId)
            {
                _received.Add((time, frame));
            }

            if (frame.TryDecode(out SetPositionTargetGlobalInt setPoint))
                _setPoint = setPoint;

            if (CommandOf(frame) is { } command)
                Later(Latency, () => Answer(frame, command));
        }
    }

    // The mode is that of the moment in which the request comes.
    private void Report()
    {
        ReportRequests++;
        if (ReportAnswer is not { } result || !Beats)
            return;
        Acknowledge(MavCmd.RequestMessage, result);
        if (result == MavResult.Accepted)
            Beat();
    }

    private void Answer(MavlinkFrame frame, MavCmd command)
    {
        if (Script(frame, command) is { } result)
            Acknowledge(command, result);
    }

    private void Act()
    {
        double now = Rig.Reactor.Now.TotalSeconds;
        foreach ((double Due, Action Act) entry in _due.Where(d => d.Due <= now + 1e-9).OrderBy(d => d.Due).ToList())
        {
            _due.Remove(entry);
            entry.Act();
        }
    }

    private static void Assert(bool condition)
    {
        if (!condition)
            throw new InvalidOperationException("The autopilot could not be made ready for the test.");
    }
}
