using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>Streams, requests, parameters, time.</summary>
public class ProtocolTests(ITestOutputHelper output)
{
    [Fact]
    public void Streams_NotAsked_OnlyHeartbeatsAndItsOwnQuestions()
    {
        using var ground = new Ground();
        ground.Run(30);
        int[] kinds = ground.Frames.Select(f => f.Frame.MessageId).Distinct().OrderBy(i => i).ToArray();
        Assert.Equal([Heartbeat.MavlinkId, Timesync.MavlinkId, Statustext.MavlinkId], kinds);
        Assert.InRange(ground.Count<Heartbeat>(), 29, 31);
        Assert.Equal(
            (MavType.Quadrotor, MavAutopilot.Ardupilotmega), (ground.Heartbeat.Type, ground.Heartbeat.Autopilot));
        Assert.Equal(81, (int)ground.Heartbeat.BaseMode);
    }

    [Theory]
    [InlineData(25)]
    [InlineData(10)]
    [InlineData(1)]
    [InlineData(100)]
    public void Stream_Asked_ComesAtItsRate(double hertz)
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Accepted, ground.Stream(Attitude.MavlinkId, hertz));
        ground.Run(20);
        Assert.InRange(ground.Count<Attitude>(), (hertz * 20) - 3, (hertz * 20) + 3);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.SetMessageInterval, Attitude.MavlinkId, -1));
        ground.Forget();
        ground.Run(5);
        Assert.Equal(0, ground.Count<Attitude>());
    }

    [Fact]
    public void Stream_TooFastOrUnknown_IsDenied()
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Denied, ground.Stream(Attitude.MavlinkId, 400));
        Assert.Equal(MavResult.Denied, ground.Stream(12_345, 1));
        Assert.Equal(MavResult.Denied, ground.Command(MavCmd.SetMessageInterval, float.NaN, 1000));
        Assert.Equal(MavResult.Accepted, ground.Stream(Attitude.MavlinkId, 200));
        ground.Run(10);
        Assert.InRange(ground.Count<Attitude>(), 950, 1010);
    }

    [Fact]
    public void DataStream_TheOldRequest_IsServedToo()
    {
        using var ground = new Ground();
        ground.Send(
            new RequestDataStream
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ReqStreamId = MavDataStream.Extra1,
                ReqMessageRate = 10,
                StartStop = 1
            });
        ground.Run(10);
        Assert.InRange(ground.Count<Attitude>(), 98, 102);
    }

    [Fact]
    public void AllStreams_InFlight_ReportTheTruthWithinTheirErrors()
    {
        using var ground = new Ground(new SimulationOptions { Seed = 5 });
        output.WriteLine("seed 5");
        int[] streams =
        [
            Attitude.MavlinkId, GlobalPositionInt.MavlinkId, SysStatus.MavlinkId, BatteryStatus.MavlinkId,
            GpsRawInt.MavlinkId, SystemTime.MavlinkId,
            ExtendedSysState.MavlinkId, LocalPositionNed.MavlinkId, VfrHud.MavlinkId, Wind.MavlinkId,
            GimbalDeviceAttitudeStatus.MavlinkId,
        ];
        foreach (int stream in streams)
            Assert.Equal(MavResult.Accepted, ground.Stream(stream, 2));
        ground.Run(1);
        Assert.Equal((0, 0), (ground.Last<GlobalPositionInt>().Lat, ground.Last<GlobalPositionInt>().Lon));
        Assert.Equal(GpsFixType.NoFix, ground.Last<GpsRawInt>().FixType);
        Assert.Equal(0ul, ground.Last<SystemTime>().TimeUnixUsec);
        ground.TakeOff(20);
        ground.Run(2);

        Assert.InRange(ground.Last<GlobalPositionInt>().RelativeAlt, 18_000, 22_000);
        Assert.InRange(ground.Last<GlobalPositionInt>().Alt, 600_000, 608_000);
        Assert.Equal(GpsFixType.Type3dFix, ground.Last<GpsRawInt>().FixType);
        Assert.InRange(ground.Last<BatteryStatus>().Voltages[0], 11_000, 12_600);
        Assert.InRange(ground.Last<SysStatus>().CurrentBattery, 1000, 2500);
        Assert.InRange(ground.Last<LocalPositionNed>().Z, -22f, -18f);
        Assert.InRange(ground.Last<Wind>().Speed, 1f, 6f);
        Assert.Equal(Math.Sqrt(0.5), ground.Last<GimbalDeviceAttitudeStatus>().Q[0], 5);
        Assert.Equal(-Math.Sqrt(0.5), ground.Last<GimbalDeviceAttitudeStatus>().Q[2], 5);
        ulong utc = ground.Last<SystemTime>().TimeUnixUsec;
        DateTimeOffset start = new(2000, 1, 1, 0, 0, 0, TimeSpan.Zero);
        Assert.InRange((utc / 1e6) - start.ToUnixTimeSeconds(), ground.Now.TotalSeconds - 1, ground.Now.TotalSeconds);
    }

    [Fact]
    public void RequestMessage_KnownAndUnknown()
    {
        using var ground = new Ground();
        ground.Run(6);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.RequestMessage, AutopilotVersion.MavlinkId));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.RequestMessage, HomePosition.MavlinkId));
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.RequestMessage, 12_345));
        ground.Run(0.2);
        Assert.True((ground.Last<AutopilotVersion>().Capabilities & MavProtocolCapability.ParamEncodeCCast) != 0);
        Assert.InRange(ground.Last<HomePosition>().Latitude, -353_632_820, -353_632_420);
    }

    [Fact]
    public void Home_OnArming_IsBroadcast()
    {
        using var ground = new Ground();
        ground.Run(6);
        ground.SetMode(CopterMode.Guided);
        ground.Command(MavCmd.ComponentArmDisarm, 1);
        ground.Run(0.2);
        Assert.Equal(1, ground.Count<HomePosition>());
        Assert.Equal(1, ground.Count<GpsGlobalOrigin>());
    }

    [Fact]
    public void Parameters_ListReadSet_AsArduPilotDoes()
    {
        using var ground = new Ground();
        ground.Send(new ParamRequestList { TargetSystem = 1, TargetComponent = 1 });
        ground.Run(2);
        ParamValue[] list = ground.All<ParamValue>().Select(p => p.Message).ToArray();
        Assert.All(list, p => Assert.Equal(list.Length, p.ParamCount));
        Assert.Equal(Enumerable.Range(0, list.Length), list.Select(p => (int)p.ParamIndex));
        Assert.Contains(
            list, p => p.ParamId.ToString() == "RTL_ALT" && p.Value.Equals(1500f) && p.ParamType == MavParamType.Int32);

        ground.Forget();
        ground.Send(
            new ParamRequestRead
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamIndex = -1,
                ParamId = new Text16("GUID_TIMEOUT")
            });
        ground.Send(new ParamRequestRead { TargetSystem = 1, TargetComponent = 1, ParamIndex = 0 });
        ground.Send(
            new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamId = new Text16("RTL_ALT"),
                ParamValue = 2500.7f,
                ParamType = MavParamType.Int32
            });
        ground.Send(
            new ParamSet { TargetSystem = 1, TargetComponent = 1, ParamId = new Text16("NO_SUCH"), ParamValue = 1 });
        ground.Run(1);
        Assert.Equal(
            ["GUID_TIMEOUT 3 65535", "SYSID_THISMAV 1 0", "RTL_ALT 2500 65535"],
            ground.All<ParamValue>().Select(
                p => FormattableString.Invariant($"{p.Message.ParamId} {p.Message.Value} {p.Message.ParamIndex}")));
    }

    [Fact]
    public void SystemId_ChangedByParameter_IsUsedAtOnce()
    {
        using var ground = new Ground();
        ground.Send(
            new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamId = new Text16("SYSID_THISMAV"),
                ParamValue = 7
            });
        ground.Run(2);
        Assert.Equal(7, ground.Frames[ground.Frames.Count - 1].Frame.SystemId);
    }

    [Fact]
    public void Timesync_AgainstADriftingClock_AnswersWithItsTime()
    {
        using var ground = new Ground(
            new SimulationOptions
            {
                BootedBefore = TimeSpan.FromSeconds(42),
                ClockDriftPpm = 200,
                TelemetryLatency = TimeSpan.Zero
            });
        ground.Stream(Attitude.MavlinkId, 10);
        double at100 = Offset(ground, 100);
        double at500 = Offset(ground, 500);
        Assert.Equal(42 + (100 * 200e-6), at100, 3);
        Assert.Equal(400 * 200e-6, at500 - at100, 3);
        Assert.InRange((ground.Last<Attitude>().TimeBootMs / 1000.0) - (500 + 42 + (500 * 200e-6)), -0.15, 0.15);
    }

    [Fact]
    public void Latency_OfTelemetry_IsAsStated()
    {
        using var ground = new Ground(new SimulationOptions { BootedBefore = TimeSpan.Zero, ClockDriftPpm = 0 });
        ground.Stream(Attitude.MavlinkId, 25);
        ground.Run(60);
        double[] late = ground.All<Attitude>().Select(a => (a.Time.TotalMilliseconds - a.Message.TimeBootMs)).ToArray();
        output.WriteLine($"{late.Min():0.0} to {late.Max():0.0} ms, mean {late.Average():0.0}");
        Assert.InRange(late.Min(), 20, 21.1);
        Assert.InRange(late.Average(), 22, 27);
        Assert.InRange(late.Max(), 25, 51);
    }

    private static double Offset(Ground ground, double atSeconds)
    {
        ground.Run(atSeconds - ground.Now.TotalSeconds);
        long asked = ground.Now.Ticks * 100;
        ground.Send(new Timesync { Ts1 = asked, TargetSystem = 1, TargetComponent = 1 });
        ground.Run(0.1);
        Timesync answer = ground.All<Timesync>().Last(t => t.Message.Tc1 != 0).Message;
        Assert.Equal(
            (asked, Ground.SystemId, Ground.ComponentId), (answer.Ts1, answer.TargetSystem, answer.TargetComponent));
        return (answer.Tc1 - asked) / 1e9;
    }
}
