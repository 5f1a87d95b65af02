using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>A simulated PX4 with two links, stepped by a test: what it sends is kept with its time.</summary>
internal sealed class Px4Flyer
{
    private const int PollLink = 2;   // only to ask for heartbeats, which the others would not show

    private readonly SimulatedWorld _world;
    private readonly List<(double Time, MavlinkFrame Frame)>[] _frames = [[], []];
    private readonly double _start;
    private Heartbeat _heartbeat;
    private TimeSpan _time;
    private byte _sequence;

    public Px4Flyer(GeodeticPosition? home = null, double start = 0)
    {
        _start = start;
        var options = new SimulationOptions
        {
            Autopilot = SimulatedAutopilot.Px4,
            WindMetresPerSecond = 0,
            PositionAfter = TimeSpan.Zero,
            IsPrepared = false,
        };
        if (home is { } place)
            options.Home = place;
        Home = options.Home;
        _world = new SimulatedWorld(options);
        Vehicle = _world.CreateVehicle(linkCount: 3);
    }

    public GeodeticPosition Home { get; }

    public SimulatedVehicle Vehicle { get; }

    public double Time => _start + _time.TotalSeconds;

    public TruePose Pose => _world.Truth.Pose;

    public Px4Mode Mode => (Px4Mode)Vehicle.Autopilot.CustomMode;

    public IReadOnlyList<(double Time, MavlinkFrame Frame)> Frames(int link) => _frames[link];

    public IEnumerable<(double Time, T Message)> All<T>(int link = 0)
        where T : struct, IMavlinkMessage
    {
        foreach ((double time, MavlinkFrame frame) in _frames[link])
        {
            if (frame.TryDecode(out T message))
                yield return (time, message);
        }
    }

    public IEnumerable<Px4Event> Events => All<Event>().Select(e => (Px4Event)e.Message.Id);

    public void Step()
    {
        _time += TimeSpan.FromSeconds(SimulatedVehicle.StepSeconds);
        Vehicle.Step(_time, DateTimeOffset.FromUnixTimeSeconds(1_800_000_000) + _time);
        Take();
    }

    public void Run(double seconds, Action? each = null)
    {
        for (int step = 0; step < seconds / SimulatedVehicle.StepSeconds; step++)
        {
            each?.Invoke();
            Step();
        }
    }

    public void RunUntil(Func<bool> condition, double atMostSeconds, string what, Action? each = null)
    {
        double end = Time + atMostSeconds;
        while (!condition())
        {
            if (Time > end)
                throw new Xunit.Sdk.XunitException(
                    $"not within {atMostSeconds} s: {what}; {Mode}, height {-Pose.Position.Down:0.0} m");
            each?.Invoke();
            Step();
        }
    }

    public void Send<T>(int link, in T message, byte system, byte component)
        where T : struct, IMavlinkMessage
    {
        Vehicle.Handle(MavlinkFrame.Create(message, system, component, _sequence++), _time, link);
        Take();
    }

    /// <summary>Sends a COMMAND_LONG of the companion or the ground station, and reads the answer.</summary>
    public MavResult? Command(MavCmd command, float p1 = 0, float p2 = 0, float p3 = 0, float p7 = 0, int link = 0)
    {
        Send(link, new CommandLong
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Command = command,
            Param1 = p1,
            Param2 = p2,
            Param3 = p3,
            Param4 = float.NaN,
            Param5 = float.NaN,
            Param6 = float.NaN,
            Param7 = p7,
        }, link == 0 ? (byte)1 : (byte)255, link == 0 ? (byte)191 : (byte)190);
        return Answer(command, link);
    }

    public MavResult? Command(in CommandInt command, int link = 0)
    {
        Send(link, command, 1, 191);
        return Answer(command.Command, link);
    }

    public MavResult? SetMode(Px4Mode mode, int link = 0)
        => Command(
            MavCmd.DoSetMode, (float)MavModeFlag.CustomModeEnabled, (byte)((uint)mode >> 16), (byte)((uint)mode >> 24),
            link: link);

    /// <summary>Sets a parameter of PX4's, which is a whole number where its value in the model is one.</summary>
    public void Set(string name, double value)
    {
        Send(1, new ParamRequestRead
        {
            TargetSystem = 1,
            TargetComponent = 1,
            ParamIndex = -1,
            ParamId = new Text16(name),
        }, 255, 190);
        MavParamType type = All<ParamValue>(1).Last(p => p.Message.ParamId.TextEquals(name)).Message.ParamType;
        var parameter = new Px4Parameter(name, type == MavParamType.Int32, value);
        Send(1, new ParamSet
        {
            TargetSystem = 1,
            TargetComponent = 1,
            ParamId = new Text16(name),
            ParamType = type,
            ParamValue = parameter.WireValue,
        }, 255, 190);
    }

    public void TakeOff(double height = 12)
    {
        Step();
        SetMode(Px4Mode.Loiter);
        Xunit.Assert.Equal(MavResult.Accepted, Command(MavCmd.ComponentArmDisarm, 1));
        Xunit.Assert.Equal(
            MavResult.Accepted, Command(MavCmd.NavTakeoff, p7: (float)(Home.AltitudeAmslMetres + height)));
        RunUntil(() => Mode == Px4Mode.Loiter, 40, "taken off");
    }

    /// <summary>The heartbeat that a REQUEST_MESSAGE is answered with.</summary>
    public Heartbeat AskForHeartbeat()
    {
        Send(PollLink, new CommandLong
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Command = MavCmd.RequestMessage,
            Param1 = Heartbeat.MavlinkId,
        }, 2, 1);
        return _heartbeat;
    }

    public void UploadFence(JsonElement fence)
        => UploadFence(fence.GetProperty("points").EnumerateArray()
            .Select(p => (p[0].GetDouble(), p[1].GetDouble())).ToArray());

    public void UploadFence((double Latitude, double Longitude)[] corners)
    {
        Send(0, new MissionCount
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Count = (ushort)corners.Length,
            MissionType = MavMissionType.Fence,
        }, 1, 191);
        for (int index = 0; index < corners.Length; index++)
        {
            Send(0, new MissionItemInt
            {
                TargetSystem = 1,
                TargetComponent = 1,
                Seq = (ushort)index,
                Frame = MavFrame.Global,
                Command = MavCmd.NavFencePolygonVertexInclusion,
                Param1 = corners.Length,
                X = (int)Math.Round(corners[index].Latitude * 1e7),
                Y = (int)Math.Round(corners[index].Longitude * 1e7),
                MissionType = MavMissionType.Fence,
            }, 1, 191);
        }
    }

    private MavResult? Answer(MavCmd command, int link)
    {
        MavResult? result = null;
        foreach ((double _, CommandAck ack) in All<CommandAck>(link))
        {
            if (ack.Command == command)
                result = ack.Result;
        }

        return result;
    }

    private void Take()
    {
        for (int link = 0; link < 2; link++)
        {
            while (Vehicle.TryTakeFrame(out MavlinkFrame frame, link))
                _frames[link].Add((Time, frame));
        }

        while (Vehicle.TryTakeFrame(out MavlinkFrame frame, PollLink))
        {
            if (frame.TryDecode(out Heartbeat heartbeat))
                _heartbeat = heartbeat;
        }
    }
}
