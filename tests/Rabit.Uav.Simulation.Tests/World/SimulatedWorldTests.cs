using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.World;

/// <summary>The world as a whole: the same from the same seed, fast, with faults as scripted.</summary>
public class SimulatedWorldTests(ITestOutputHelper output)
{
    [Fact]
    public void TakePlacesFrom_MissionWithoutHome_StandsAtTheFirstCorner()
    {
        const string Mission = """
            { "area": [[10, 20], [10, 20.001], [10.001, 20.001], [10.001, 20]], "heightMetres": 40, "speedMetresPerSecond": 6, "laneSpacingMetres": 30 }
            """;
        var options = new SimulationOptions();
        options.TakePlacesFrom(MissionPlan.Parse(Mission, "test"));

        Assert.Equal(
            (10, 20), (Math.Round(options.Home.Latitude.Degrees, 9), Math.Round(options.Home.Longitude.Degrees, 9)));
        Assert.Equal((0, 0), (Math.Round(options.Area[0].North, 3), Math.Round(options.Area[0].East, 3)));
    }

    [Theory]
    [InlineData(false, -45, 30)]   // fixed there
    [InlineData(true, -90, 0)]     // to be pointed there
    public void TakePlacesFrom_CameraOfTheMission_LooksThereIfItIsFixed(bool hasGimbal, double pitch, double yaw)
    {
        var options = new SimulationOptions();
        options.TakePlacesFrom(new MissionPlan
        {
            Area = [Corner(10, 20), Corner(10, 20.001), Corner(10.001, 20.001)],
            CameraPitch = Angle.FromDegrees(-45),
            CameraYaw = Angle.FromDegrees(30),
            HasGimbal = hasGimbal,
        });

        Assert.Equal(
            (pitch, yaw), (Math.Round(options.Camera.Pitch.Degrees, 9), Math.Round(options.Camera.Yaw.Degrees, 9)));
    }

    [Fact]
    public void New_CameraLooksWhereItCannot_IsRefused()
    {
        var options = new SimulationOptions();
        options.Camera.Pitch = Angle.FromDegrees(45);

        ArgumentException fault = Assert.Throws<ArgumentException>(() => new SimulatedWorld(options));
        Assert.Contains("Pitch and Yaw are 45 and 0 degrees", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void SameSeed_SixtySecondsOfFlight_SendTheSameBytes()
    {
        string first = HashOfAFlight(4);
        Assert.Equal(first, HashOfAFlight(4));
        Assert.NotEqual(first, HashOfAFlight(5));
    }

    [Fact]
    public void SameSeed_AnotherOrderAmongEqualManagers_FliesTheSame()
        => Assert.Equal(HashOfAFlight(4, timeSeed: 1), HashOfAFlight(4, timeSeed: 2));

    [Fact]
    public void Speed_TenSimulatedMinutes_TakeAFewSeconds()
    {
        // Once before, so that nothing is compiled while the clock runs.
        HashOfAFlight(1);
        using var ground = new Ground();
        AskForStreams(ground);
        using var process = Process.GetCurrentProcess();
        var clock = Stopwatch.StartNew();
        TimeSpan busyBefore = process.TotalProcessorTime;
        TimeSpan start = ground.Now;
        ground.TakeOff(20);
        Search(ground, 600);
        double simulated = (ground.Now - start).TotalSeconds;
        process.Refresh();
        double busy = (process.TotalProcessorTime - busyBefore).TotalSeconds;   // of this alone only if it runs alone
        output.WriteLine($"{simulated:0} s simulated in {clock.Elapsed.TotalSeconds:0.00} s, {busy:0.00} s of CPU: "
            + $"{simulated / busy:0} s in a second of CPU");
        Assert.True(clock.Elapsed.TotalSeconds < 20, $"{clock.Elapsed.TotalSeconds:0.0} s");
    }

    [Fact]
    public void LinkSilent_NeitherReceivesNorSends_AndFliesOn()
    {
        using var ground = new Ground(With(new ScriptedFault
        {
            Kind = ScriptedFaultKind.LinkSilent,
            At = TimeSpan.FromSeconds(40),
            Duration = TimeSpan.FromSeconds(10),
        }));
        ground.TakeOff(10);
        ground.GoTo(100, 0, 10);
        ground.Run(41 - ground.Now.TotalSeconds);
        ground.Forget();
        long lost = ground.Truth.FramesLost;
        ground.Send(new CommandLong { TargetSystem = 1, TargetComponent = 1, Command = MavCmd.NavLand });
        ground.Run(8.9);
        Assert.Empty(ground.Frames);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        Assert.True(ground.Truth.FramesLost > lost);
        Assert.True(ground.Truth.Pose.Position.North > 20);
        ground.Run(3);
        Assert.True(ground.Count<Heartbeat>() >= 2);
    }

    [Fact]
    public void LinkEnds_AfterATornFrame_FramesAfterItAreReceived()
    {
        using var ground = new Ground();
        ground.Run(1);
        long received = ground.Truth.FramesReceived;

        byte[] torn = [0xFD, 200, 0, 0, 0, 1, 1, 0xEF, 0xCD, 0xAB];
        ground.Link.Write(torn, 0, torn.Length);
        ground.Send(
            new CommandLong { TargetSystem = 1, TargetComponent = 1, Command = MavCmd.RequestMessage, Param1 = 148 });
        ground.Link.Dispose();
        ground.Run(1);

        Assert.Equal(received + 1, ground.Truth.FramesReceived);
    }

    [Fact]
    public void BatteryTo_IsReportedWithWarningAndCriticalStatus()
    {
        using var ground = new Ground(
            With(
                new ScriptedFault { Kind = ScriptedFaultKind.BatteryTo, At = TimeSpan.FromSeconds(35), Value = 0.08 }));
        ground.Stream(SysStatus.MavlinkId, 2);
        ground.TakeOff(10);
        ground.Run(36 - ground.Now.TotalSeconds);
        Assert.Equal(8, ground.Last<SysStatus>().BatteryRemaining);
        ground.Run(12);
        Assert.Contains(ground.Texts, t => t.StartsWith("Battery 1 is low ", StringComparison.Ordinal));
        Assert.Equal(MavState.Critical, ground.Heartbeat.SystemStatus);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);   // by default it does nothing about it
    }

    [Fact]
    public void BatteryTo_FailsafeSwitchedOn_Returns()
    {
        using var ground = new Ground(
            With(
                new ScriptedFault { Kind = ScriptedFaultKind.BatteryTo, At = TimeSpan.FromSeconds(35), Value = 0.08 }));
        ground.Send(
            new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamId = new Text16("BATT_FS_LOW_ACT"),
                ParamValue = 2
            });
        ground.TakeOff(10);
        ground.Run(50 - ground.Now.TotalSeconds);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void BatteryEmpty_InFlight_Falls()
    {
        using var ground = new Ground(
            With(new ScriptedFault { Kind = ScriptedFaultKind.BatteryTo, At = TimeSpan.FromSeconds(35), Value = 0 }));
        ground.TakeOff(20);
        ground.Run(45 - ground.Now.TotalSeconds);
        Assert.True(ground.Truth.HasCrashed);
    }

    [Fact]
    public void GroundFailsafe_SwitchedOn_ReturnsWhenTheGroundStationIsLost()
    {
        using var ground = new Ground();
        ground.Send(
            new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamId = new Text16("FS_GCS_ENABLE"),
                ParamValue = 1
            });
        ground.TakeOff(10);
        for (int second = 0; second < 8; second++)
        {
            ground.Send(new Heartbeat { Type = MavType.Gcs });
            ground.Run(1);
        }

        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        ground.Run(6);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void WindTo_ForAWhile_BlowsForThatWhile()
    {
        var options = With(
            new ScriptedFault
            {
                Kind = ScriptedFaultKind.WindTo,
                At = TimeSpan.FromSeconds(20),
                Duration = TimeSpan.FromSeconds(30),
                Value = 12
            });
        options.WindMetresPerSecond = 1;
        using var ground = new Ground(options);
        ground.Stream(Wind.MavlinkId, 5);
        ground.Run(19);
        Assert.InRange(MeanWind(ground), 0, 2);
        ground.Run(16);
        Assert.InRange(MeanWind(ground), 8, 16);
        ground.Run(25);
        Assert.InRange(MeanWind(ground), 0, 3);
    }

    [Fact]
    public void PilotMode_TakesOver_AtItsTime()
    {
        using var ground = new Ground(
            With(new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, At = TimeSpan.FromSeconds(40), Value = 5 }));
        ground.TakeOff(10);
        ground.GoTo(200, 0, 10);
        ground.Run(39.5 - ground.Now.TotalSeconds);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Heartbeat.CustomMode);
        ground.Run(8);
        Assert.Equal(CopterMode.Loiter, (CopterMode)ground.Heartbeat.CustomMode);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, -0.5, 0.5);
    }

    [Fact]
    public void Truth_OfAFlight_HasItsPath()
    {
        using var ground = new Ground();
        ground.TakeOff(15);
        ground.GoTo(40, 0, 15);
        ground.Run(20);
        SimulatedTruth truth = ground.Truth;
        Assert.True(truth.IsAirborne && truth.IsArmed && truth.HasFlown);
        Assert.Null(truth.Landing);
        Assert.InRange(truth.MaxHeightMetres, 14, 18);
        Assert.InRange(truth.MaxDistanceMetres, 36, 44);
        Assert.InRange(truth.FlownMetres, 36, 50);
        double[] steps = truth.Path.Skip(2).Zip(truth.Path.Skip(1), (b, a) => (b.Time - a.Time).TotalSeconds).ToArray();
        Assert.All(steps, s => Assert.Equal(0.2, s, 6));
        Assert.True(ground.World.History.TryGet(ground.Now - TimeSpan.FromSeconds(3), out TruePose old));
        Assert.Equal(ground.Now - TimeSpan.FromSeconds(3), old.Time);
    }

    [Fact]
    public void LinkEnds_VehicleFliesOn()
    {
        using var ground = new Ground();
        ground.TakeOff(10);
        ground.GoTo(50, 0, 10);
        ground.Run(0.5);
        ground.Link.Unblock();
        ground.Run(20);
        Assert.InRange(ground.Truth.Pose.Position.North, 45, 55);
        Assert.Single(ground.Log, l => l.Text.Contains("the link has ended"));
    }

    [Fact]
    public void CreateVehicle_Twice_Throws()
    {
        var world = new SimulatedWorld(new SimulationOptions());
        var pair = new MemoryLinkPair("twice");
        world.CreateVehicle(pair.A);
        Assert.Throws<InvalidOperationException>(() => world.CreateVehicle(pair.B));
    }

    [Fact]
    public void Options_Wrong_AreNamedAllTogether()
    {
        var options = new SimulationOptions
        {
            WindMetresPerSecond = -1,
            BarometerDriftMetres = double.NaN,
            BatteryRemaining = 2,
            Area = [],
            Faults =
            [
                new ScriptedFault { Kind = ScriptedFaultKind.PilotMode, Value = 99 },
                new ScriptedFault { Kind = ScriptedFaultKind.LinkSilent },
                new ScriptedFault { Kind = ScriptedFaultKind.Gust, Value = 9 },
                new ScriptedFault { Kind = ScriptedFaultKind.ComputerHot, Value = 400 },
                new ScriptedFault { Kind = ScriptedFaultKind.DiskLow, Value = -1 },
            ],
        };
        var e = Assert.Throws<ArgumentException>(() => new SimulatedWorld(options));
        foreach (string name
            in (string[])["WindMetresPerSecond", "BarometerDriftMetres", "BatteryRemaining", "Area", "PilotMode",
                "LinkSilent", "Gust at", "ComputerHot", "DiskLow"])
            Assert.Contains(name, e.Message, StringComparison.Ordinal);
    }

    private static GeodeticPosition Corner(double latitude, double longitude)
        => GeodeticPosition.FromDegrees(latitude, longitude, 0);

    private static SimulationOptions With(ScriptedFault fault) => new() { Faults = [fault] };

    private static double MeanWind(Ground ground)
        => ground.All<Wind>().Reverse().Take(15).Average(w => w.Message.Speed);

    private static void AskForStreams(Ground ground)
    {
        ground.Stream(Attitude.MavlinkId, 25);
        ground.Stream(GlobalPositionInt.MavlinkId, 10);
        ground.Stream(SysStatus.MavlinkId, 1);
        ground.Stream(BatteryStatus.MavlinkId, 1);
        ground.Stream(GpsRawInt.MavlinkId, 2);
        ground.Stream(SystemTime.MavlinkId, 1);
        ground.Stream(ExtendedSysState.MavlinkId, 2);
    }

    private static void Search(Ground ground, double seconds)
    {
        TimeSpan end = ground.Now + TimeSpan.FromSeconds(seconds);
        for (int lane = 0; ground.Now < end; lane++)
        {
            ground.GoTo(30 + (20 * (lane % 6)), lane % 2 == 0 ? 80 : -80, 40);
            ground.Run(20);
        }
    }

    private static string HashOfAFlight(long seed, long timeSeed = 0)
    {
        using var ground = new Ground(new SimulationOptions { Seed = seed, WindMetresPerSecond = 5 }, timeSeed);
        AskForStreams(ground);
        ground.TakeOff(20);
        Search(ground, 60);

        // FNV-1a over the frames and the times of their arrival.
        ulong hash = 14_695_981_039_346_656_037;
        foreach (byte value in ground.Frames.SelectMany(f => Bytes(f.Time, f.Frame)))
            hash = (hash ^ value) * 1_099_511_628_211;
        return $"{ground.Frames.Count} frames, {hash:x16}";
    }

    private static IEnumerable<byte> Bytes(TimeSpan time, MavlinkFrame frame)
    {
        byte[] bytes = new byte[frame.WireLength];
        frame.WriteTo(bytes);
        return BitConverter.GetBytes(time.Ticks).Concat(bytes);
    }
}
