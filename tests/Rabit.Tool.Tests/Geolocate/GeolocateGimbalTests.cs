using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Tests;
using Xunit;

namespace Rabit.Tool.Tests.Geolocate;

/// <summary><c>rabit geolocate</c> with a gimbal: as the request says, or as a telemetry log reports it.</summary>
public sealed class GeolocateGimbalTests : IDisposable
{
    private const long StampMicroseconds = 1_700_000_000_000_000;
    private const byte Autopilot = 1;
    private const byte Gimbal = (byte)MavComponent.Gimbal;

    // 40 m above the ground; a gimbal that looks 60 degrees down sees it 23.09 m away.
    private const double Distance = 23.094;
    private const GimbalDeviceFlags Locks = GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock;
    private const GimbalDeviceFlags North = Locks | GimbalDeviceFlags.YawInEarthFrame;
    private const GimbalDeviceFlags Heading = Locks | GimbalDeviceFlags.YawInVehicleFrame;

    private static readonly LocalNedFrame World = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47, 8, 540));

    private readonly GeolocateFiles _run = new();

    public void Dispose() => _run.Dispose();

    // The right side of the picture is turned down.
    [Fact]
    public void Request_RollOfTheGimbal_TurnsThePictureRightSideDown()
    {
        NedPosition turned = Place("""{"rollDegrees":90,"pitchDegrees":-60,"yawDegrees":0}""", "[419.5,239.5]");
        NedPosition level = Place("""{"rollDegrees":0,"pitchDegrees":-60,"yawDegrees":0}""", "[319.5,339.5]");
        NedPosition without = Place("""{"pitchDegrees":-60,"yawDegrees":0}""", "[319.5,339.5]");

        Assert.Equal(level.North, turned.North, 1e-6);
        Assert.Equal(level.East, turned.East, 1e-6);
        Assert.Equal(level.North, without.North, 1e-9);
        Assert.InRange(level.North, 1, Distance - 5);

        NedPosition Place(string gimbal, string pixel)
        {
            string request = GeolocateFiles.Pose.Replace("\"groundAlt", $"\"gimbal\":{gimbal},\"groundAlt")
                .Replace("[319.5,239.5]", pixel);
            Assert.Equal(0, _run.Run(
                _run.File("camera.json", GeolocateFiles.Camera), _run.File("posed.json", request), "--json"));
            return World.ToNed(_run.Place);
        }
    }

    // The vehicle rolls and looks to 30 degrees; the gimbal holds the horizon and looks east.
    [Theory]
    [InlineData(90, North)]
    [InlineData(60, Heading)]
    public void Log_DeviceStatus_PointsTheCameraInTheFrameOfItsFlags(double yaw, GimbalDeviceFlags flags)
    {
        AssertEast(102.04, log => Every(t => log.Write(t, Status(t, -60, yaw, flags), Autopilot)));
    }

    [Theory]
    [InlineData(90, 0)]
    [InlineData(float.NaN, 60)]
    public void Log_MountOrientation_PointsTheCameraByItsAbsoluteYawOrTheHeading(float absolute, float yaw)
    {
        AssertEast(102.04, log => Every(t => log.Write(t, Mount(t, yaw, absolute), Autopilot)));
    }

    // Its clock is another one: the stamps of the log say when it was so.
    [Fact]
    public void Log_GimbalItselfReports_IsTakenByTheStampsOfTheLog()
    {
        AssertEast(102.04, log => Every(
            t => log.Write(t, Status(t - 77, -60, t < 101.9 ? -90 : 90, North), Gimbal)));
    }

    // 10 degrees a second about north: between its reports, which are a second apart.
    [Fact]
    public void Log_GimbalTurns_IsInterpolated()
    {
        AssertEast(102.4, log =>
        {
            for (int t = 100; t <= 105; t++)
                log.Write(t, Status(t, -60, 90 + (10 * (t - 102.4)), North), Autopilot);
        });
    }

    [Fact]
    public void Log_GimbalOfAnotherVehicle_IsNotUsed()
    {
        AssertEast(102.04, log => Every(t =>
        {
            log.Write(t, Status(t, -60, -90, North), Autopilot, system: 9);
            log.Write(t, Status(t, -60, 90, North), Autopilot);
        }));
    }

    [Fact]
    public void Log_RequestSaysWhereTheGimbalPoints_ComesBeforeTheLog()
    {
        AssertEast(
            102.04, log => Every(t => log.Write(t, Status(t, -60, -90, North), Autopilot)),
            gimbal: """ "gimbal":{"pitchDegrees":-60,"yawDegrees":60}, """);
    }

    // The angles of before are no substitute: where it points now is not known.
    [Theory]
    [InlineData(101.5, 0, "")]
    [InlineData(102.4, 0, "")]
    [InlineData(103.5, 1, "NoPose")]
    public void Log_GimbalFellSilent_IsRefusedAfterOneAndAHalfSeconds(double seconds, int code, string reason)
    {
        Assert.Equal(code, Run(seconds, log =>
        {
            for (double t = 100; t < 101.1; t += 0.5)
                log.Write(t, Status(t, -60, 90, North), Autopilot);
        }));
        Assert.Equal(reason, code == 0 ? "" : _run.Json.Text("reason"));
    }

    [Fact]
    public void Log_ReportsOfTheGimbalAreFarApart_IsRefused()
    {
        Assert.Equal(1, Run(102.04, log =>
        {
            log.Write(100.5, Status(100.5, -60, 90, North), Autopilot);
            log.Write(103.5, Status(103.5, -60, 90, North), Autopilot);
        }));
        Assert.Equal("PoseGap", _run.Json.Text("reason"));
    }

    // Before, its clock ran from 100 s too, 200 s earlier, and the camera looked west; after it, south.
    [Theory]
    [InlineData(102.04, 90)]
    [InlineData(1_700_000_102.04, 90)]
    [InlineData(1_699_999_902.04, -90)]
    [InlineData(1_700_000_302.04, 180)]
    public void Log_AutopilotStartedAgain_TakesTheGimbalOfTheRunOfTheTime(double seconds, double yaw)
    {
        bool isSinceBoot = seconds < 1e9;
        int code = Run(seconds, log =>
        {
            WriteRun(log, stampsLessBoot: -200, seconds: isSinceBoot ? 40 : 100, yawDegrees: -90);
            Every(t => log.Write(t, Status(t, -60, 90, North), Autopilot));
            WriteRun(log, stampsLessBoot: 200, seconds: isSinceBoot ? 40 : 100, yawDegrees: 180);
        });

        Assert.True(code == 0, _run.Errors);
        NedPosition place = World.ToNed(_run.Place);
        Assert.Equal(Distance * Math.Cos(yaw * Vectors.Degree), place.North, 0.02);
        Assert.Equal(Distance * Math.Sin(yaw * Vectors.Degree), place.East, 0.02);
    }

    [Fact]
    public void Log_TimeIsOfTwoRunsOfTheAutopilot_IsRefusedByName()
    {
        Assert.Equal(2, Run(102.04, log => WriteRun(log, stampsLessBoot: 200, seconds: 100, yawDegrees: 90)));
        Assert.Contains("the autopilot started 2 times", _run.Errors);
        Assert.Contains("since 1970", _run.Errors);
    }

    private static void WriteRun(Log log, double stampsLessBoot, double seconds, double yawDegrees)
    {
        for (double boot = seconds; boot <= seconds + 6; boot += 0.1)
        {
            WritePose(log, boot, boot + stampsLessBoot);
            log.Write(boot + stampsLessBoot, Status(boot, -60, yawDegrees, North), Autopilot);
        }
    }

    private void AssertEast(double seconds, Action<Log> report, string gimbal = "")
    {
        Assert.Equal(0, Run(seconds, report, gimbal));
        NedPosition place = World.ToNed(_run.Place);
        Assert.Equal(0, place.North, 0.02);
        Assert.Equal(Distance, place.East, 0.02);
    }

    private int Run(double seconds, Action<Log> report, string gimbal = "")
    {
        string path = _run.PathOf("flight.tlog");
        using (FileStream file = File.Create(path))
        {
            var log = new Log(new TlogWriter(file));
            log.Write(-200, new Heartbeat { Autopilot = MavAutopilot.Ardupilotmega }, Autopilot);
            Every(t => WritePose(log, t));
            report(log);
            log.Finish();
        }

        return _run.Run(
            _run.File(
                "camera.json", GeolocateFiles.Camera.Replace("\"gimbal\":{}", """ "gimbal":{"frame":"heading"} """)),
            _run.File("request.json", $$"""{{{gimbal}}"groundAltitudeAmslMetres":500,"pixel":[319.5,239.5]}"""),
            "--telemetry", path, "--time", seconds.ToString(CultureInfo.InvariantCulture), "--json");
    }

    private static void Every(Action<double> write)
    {
        for (int tenth = 1000; tenth <= 1060; tenth++)
            write(tenth / 10.0);
    }

    private static void WritePose(Log log, double secondsSinceBoot, double? stamp = null)
    {
        uint boot = (uint)Math.Round(secondsSinceBoot * 1000);
        double seconds = stamp ?? secondsSinceBoot;
        log.Write(
            seconds,
            new GlobalPositionInt { TimeBootMs = boot, Lat = 470_000_000, Lon = 80_000_000, Alt = 540_000 },
            Autopilot);
        log.Write(
            seconds,
            new Attitude
            {
                TimeBootMs = boot,
                Roll = (float)(8 * Vectors.Degree),
                Yaw = (float)(30 * Vectors.Degree),
            },
            Autopilot);
    }

    private static GimbalDeviceAttitudeStatus Status(
        double seconds, double pitchDegrees, double yawDegrees, GimbalDeviceFlags flags)
    {
        Rotation rotation = Rotation.FromEuler(EulerAngles.FromDegrees(0, pitchDegrees, yawDegrees));
        var q = default(FloatArray4);
        (q[0], q[1], q[2], q[3]) = ((float)rotation.W, (float)rotation.X, (float)rotation.Y, (float)rotation.Z);
        return new GimbalDeviceAttitudeStatus
        {
            TimeBootMs = (uint)Math.Round(seconds * 1000),
            Flags = flags,
            Q = q,
            GimbalDeviceId = 1,
        };
    }

    private static MountOrientation Mount(double seconds, float yaw, float absolute) => new()
    {
        TimeBootMs = (uint)Math.Round(seconds * 1000),
        Pitch = -60,
        Yaw = yaw,
        YawAbsolute = absolute,
    };

    // Takes frames in any order, and writes them by their times.
    private sealed class Log(TlogWriter writer)
    {
        private readonly List<(double Seconds, MavlinkFrame Frame)> _frames = [];

        public void Write<T>(double seconds, T message, byte component, byte system = 1)
            where T : struct, IMavlinkMessage
            => _frames.Add((seconds, MavlinkFrame.Create(message, system, component, 0)));

        public void Finish()
        {
            foreach ((double seconds, MavlinkFrame frame) in _frames.OrderBy(f => f.Seconds))
                writer.Write(StampMicroseconds + (long)Math.Round(seconds * 1e6), frame);
        }
    }
}
