using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Uav.Simulation.Tests;

/// <summary>
/// A simulated world in virtual time, and a scripted ground station on the other end of its link: it sends what a test
/// wants and keeps every frame that comes back, with the time.
/// </summary>
internal sealed class Ground : IDisposable
{
    public const byte SystemId = 255;
    public const byte ComponentId = 190;
    public const double RadiansPerDegree = Math.PI / 180;

    private readonly MemoryLinkPair _pair = new("vehicle", 1024 * 1024);
    private readonly Station _station;
    private byte _sequence;

    public Ground(SimulationOptions? options = null, long timeSeed = 0)
    {
        Options = options ?? new SimulationOptions();
        Options.IsPrepared = false; // the autopilot as it is by itself
        World = new SimulatedWorld(Options);
        _station = new Station(_pair.B);
        Reactor = new RabitReactor(
            new ReactorOptions { Time = new VirtualTime(timeSeed), Log = Log.Add, StopsOnSignals = false })
        {
            World.CreateVehicle(_pair.A), _station,
        };
        Reactor.Start();
    }

    public SimulationOptions Options { get; }

    public SimulatedWorld World { get; }

    public RabitReactor Reactor { get; }

    public List<RabitLogEntry> Log { get; } = [];

    public IReadOnlyList<(TimeSpan Time, MavlinkFrame Frame)> Frames => _station.Frames;

    public SimulatedTruth Truth => World.Truth;

    public TimeSpan Now => Reactor.Now;

    public IByteLink Link => _pair.B;

    public Heartbeat Heartbeat => Last<Heartbeat>();

    public bool IsArmed => (Heartbeat.BaseMode & MavModeFlag.SafetyArmed) != 0;

    /// <summary>The texts so far.</summary>
    public IEnumerable<string> Texts => All<Statustext>().Select(t => t.Message.Text.ToString());

    public void Run(double seconds) => Assert(Reactor.RunFor(TimeSpan.FromSeconds(seconds)));

    /// <summary>Runs until a condition holds; fails after a time.</summary>
    public void RunUntil(Func<bool> condition, double atMostSeconds, string what)
    {
        TimeSpan end = Now + TimeSpan.FromSeconds(atMostSeconds);
        while (!condition())
        {
            if (Now >= end)
                throw new Xunit.Sdk.XunitException(
                    $"not within {atMostSeconds} s: {what}. Texts: {string.Join(" | ", Texts)}");
            Run(0.1);
        }
    }

    public void Send<T>(in T message, byte system = SystemId, byte component = ComponentId)
        where T : struct, IMavlinkMessage
    {
        byte[] bytes = new byte[MavlinkFrame.MaxWireLength];
        int length = MavlinkFrame.Create(message, system, component, _sequence++).WriteTo(bytes);
        _pair.B.Write(bytes, 0, length);
    }

    /// <summary>Sends a command and waits for its acknowledgement.</summary>
    public MavResult Command(
        MavCmd command, float p1 = 0, float p2 = 0, float p3 = 0, float p4 = 0, float p5 = 0, float p6 = 0,
        float p7 = 0)
    {
        Send(new CommandLong
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Command = command,
            Param1 = p1,
            Param2 = p2,
            Param3 = p3,
            Param4 = p4,
            Param5 = p5,
            Param6 = p6,
            Param7 = p7,
        });
        return AwaitResult(command);
    }

    public MavResult Command(in CommandInt command)
    {
        Send(command);
        return AwaitResult(command.Command);
    }

    public MavResult SetMode(CopterMode mode)
        => Command(MavCmd.DoSetMode, (float)MavModeFlag.CustomModeEnabled, (float)mode);

    /// <summary>Asks for a stream.</summary>
    public MavResult Stream(int messageId, double hertz)
        => Command(MavCmd.SetMessageInterval, messageId, (float)(1e6 / hertz));

    /// <summary>A place above home, metres, as a target in latitude and longitude.</summary>
    public void GoTo(double north, double east, double height)
    {
        GeodeticPosition place = LocalNedFrame.IgnoringGeoid(Options.Home)
            .ToGeodetic(new NedPosition(north, east, -height));
        Send(new SetPositionTargetGlobalInt
        {
            TargetSystem = 1,
            TargetComponent = 1,
            CoordinateFrame = MavFrame.GlobalRelativeAltInt,
            TypeMask = (PositionTargetTypemask)3576,
            LatInt = (int)Math.Round(place.Latitude.Degrees * 1e7),
            LonInt = (int)Math.Round(place.Longitude.Degrees * 1e7),
            Alt = (float)height,
        });
    }

    public void Fly(double north, double east, double down) => Send(new SetPositionTargetLocalNed
    {
        TargetSystem = 1,
        TargetComponent = 1,
        CoordinateFrame = MavFrame.LocalNed,
        TypeMask = (PositionTargetTypemask)3527,
        Vx = (float)north,
        Vy = (float)east,
        Vz = (float)down,
    });

    /// <summary>From the start to hovering at a height.</summary>
    public void TakeOff(double height = 20)
    {
        RunUntil(() => Texts.Contains("EKF3 IMU1 is using GPS"), 10, "a position");
        Assert(SetMode(CopterMode.Guided) == MavResult.Accepted);
        Assert(Command(MavCmd.ComponentArmDisarm, 1) == MavResult.Accepted);
        Assert(Command(MavCmd.NavTakeoff, p7: (float)height) == MavResult.Accepted);
        RunUntil(() => -Truth.Pose.Position.Down > height - 2 && Math.Abs(Truth.Pose.VelocityNed.Down) < 0.1, 60, "up");
        Run(2);
    }

    public IEnumerable<(TimeSpan Time, T Message)> All<T>()
        where T : struct, IMavlinkMessage
    {
        foreach ((TimeSpan time, MavlinkFrame frame) in Frames)
        {
            if (frame.TryDecode(out T message))
                yield return (time, message);
        }
    }

    public T Last<T>()
        where T : struct, IMavlinkMessage
        => All<T>().Last().Message;

    public int Count<T>()
        where T : struct, IMavlinkMessage
        => All<T>().Count();

    public void Forget() => _station.Frames.Clear();

    public void Dispose()
    {
        Reactor.Stop("the test is over");
        ReactorResult result = Reactor.Finish();
        Assert(result.ExitCode == 0, result.ToString());
    }

    private MavResult AwaitResult(MavCmd command)
    {
        int known = _station.Frames.Count;
        for (int wait = 0; wait < 100; wait++)
        {
            Run(0.01);
            for (; known < _station.Frames.Count; known++)
            {
                if (_station.Frames[known].Frame.TryDecode(out CommandAck ack) && ack.Command == command
                    && ack.TargetSystem == SystemId && ack.TargetComponent == ComponentId)
                {
                    return ack.Result;
                }
            }
        }

        throw new Xunit.Sdk.XunitException($"no acknowledgement of {command}");
    }

    private static void Assert(bool condition, string? text = null)
    {
        if (!condition)
            throw new Xunit.Sdk.XunitException(text ?? "the script cannot go on");
    }

    /// <summary>Keeps what comes.</summary>
    private sealed class Station : RabitManager
    {
        private readonly BlockingReader<LinkFrame> _reader;

        public Station(IByteLink link)
            : base("ground")
        {
            _reader = AttachReader("link", new MavlinkLinkSource(link), 4096);
            WakeUpDelay = TimeSpan.FromSeconds(10);
        }

        public List<(TimeSpan Time, MavlinkFrame Frame)> Frames { get; } = [];

        protected override void ExecuteUnitOfWork()
        {
            while (_reader.TryPop(out LinkFrame frame))
                Frames.Add((Now, frame.Frame));
        }
    }
}
