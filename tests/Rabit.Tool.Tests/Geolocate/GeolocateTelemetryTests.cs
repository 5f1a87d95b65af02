using System;
using System.Globalization;
using System.IO;
using System.Text;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Tests;
using Xunit;

namespace Rabit.Tool.Tests.Geolocate;

/// <summary><c>rabit geolocate</c> with poses over time: a table or a telemetry log, and a time.</summary>
public sealed class GeolocateTelemetryTests : IDisposable
{
    private const double DegE7 = 1e7;
    private const long StampMicroseconds = 1_700_000_000_000_000;

    // Straight north at 18 m/s, rolling right; ten a second from 100 to 110 s, without 105 to 107.
    private static readonly LocalNedFrame World = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47, 8, 540));

    private readonly GeolocateFiles _run = new();
    private readonly string _camera;
    private readonly string _request;

    public GeolocateTelemetryTests()
    {
        _camera = _run.File("camera.json", GeolocateFiles.Camera);
        _request = _run.File("request.json", """{"groundAltitudeAmslMetres":500,"pixel":[319.5,239.5]}""");
    }

    public void Dispose() => _run.Dispose();

    [Theory]
    [InlineData("102.04")]
    [InlineData("103")]
    [InlineData("110.05")]
    public void Table_ATime_GivesThePlaceOfThen(string time)
    {
        Assert.Equal(0, _run.Run(_camera, _request, "--telemetry", Table("log.csv"), "--time", time, "--json"));

        // A table has no rates: an extrapolated pose does not go on rolling.
        double extrapolated = _run.Json.Number("extrapolatedSeconds");
        AssertBelow(double.Parse(time, CultureInfo.InvariantCulture), extrapolated > 0 ? 0.1 : 0.02);
        Assert.Equal(time == "110.05" ? 0.05 : 0, extrapolated, 1e-6);
    }

    [Fact]
    public void Table_OtherOrderOfColumns_IsReadByTheirNames()
    {
        string[] lines = File.ReadAllLines(Table("log.csv"));
        for (int i = 0; i < lines.Length; i++)
        {
            string[] words = lines[i].Split(',');
            Array.Reverse(words);
            lines[i] = (i == 0 ? "note," : "0,") + string.Join(",", words);
        }

        Assert.Equal(0, _run.Run(
            _camera, _request, "--telemetry", _run.File("turned.csv", string.Join("\n", lines)), "--time", "102.04",
            "--json"));
        AssertBelow(102.04);
    }

    [Theory]
    [InlineData("99", "PoseTooOld")]
    [InlineData("106", "PoseGap")]
    [InlineData("110.2", "NoPose")]
    public void Table_NoPoseThen_IsRefused(string time, string reason)
    {
        Assert.Equal(1, _run.Run(_camera, _request, "--telemetry", Table("log.csv"), "--time", time, "--json"));
        Assert.Equal(("refused", reason), (_run.Json.Text("status"), _run.Json.Text("reason")));
        Assert.Equal(double.Parse(time, CultureInfo.InvariantCulture), _run.Json.Number("timeSeconds"), 1e-6);
    }

    [Theory]
    [InlineData("timeSeconds,latitudeDegrees\n1,2", "names no column longitudeDegrees")]
    [InlineData("timeSeconds,lat_deg\n1,2",
        "names a column lat_deg, of an older form of the file; it is latitudeDegrees now")]
    [InlineData("1,2,3", "Line 1 of")]
    [InlineData("1,47,8,1e9,0,0,0,0,0,0", "Line 1 of")]
    [InlineData("1,47,8,540,0,0,0,0,0,0\n2,47,8,NaN,0,0,0,0,0,0", "altitudeAmslMetres is NaN; it must be -1000 to 100000")]
    [InlineData("1,47,188,540,0,0,0,0,0,0", "longitudeDegrees is 188; it must be -180 to 180")]
    [InlineData("1,47,8,540,0,0,0,0,0,0\n2,47,8,540,0,0,0,0,zero,0", "Line 2 of")]
    [InlineData("1,47,8,540,0,0,0,0,0,0\nNaN,47,8,540,0,0,0,0,0,0", "Line 2 of")]
    [InlineData("1e300,47,8,540,0,0,0,0,0,0", "timeSeconds is 1E+300; it must be seconds, 100000000000 at most.")]
    [InlineData("", "bad.csv has no poses.")]
    [InlineData("timeSeconds,latitudeDegrees,longitudeDegrees,altitudeAmslMetres,velocityNorthMetresPerSecond,velocityEastMetresPerSecond,velocityDownMetresPerSecond,rollDegrees,pitchDegrees,yawDegrees\n", "bad.csv has no poses.")]
    public void Table_Wrong_IsNamed(string text, string message)
    {
        Assert.Equal(2, _run.Run(_camera, _request, "--telemetry", _run.File("bad.csv", text), "--time", "1"));
        Assert.Contains(message, _run.Errors);
    }

    [Theory]
    [InlineData("102.04")]
    [InlineData("1700000102.04")]
    public void Log_TimeOfItsAutopilotOrOfItsStamps_GivesThePlaceOfThen(string time)
    {
        Assert.Equal(0, _run.Run(_camera, _request, "--telemetry", Log(), "--time", time, "--json"));
        AssertBelow(102.04);
        Assert.Equal(102.04, _run.Json.Number("timeSeconds"), 1e-3);
    }

    [Fact]
    public void Telemetry_AndAPoseInTheRequest_SaysThatThatIsNotUsed()
    {
        string table = Table("log.csv");
        string request = _run.File("pose.json", GeolocateFiles.Pose);

        Assert.Equal(0, _run.Run(_camera, request, "--telemetry", table, "--time", "102.04", "--json"));

        Assert.Equal(
            $"the pose of the request is not used: {table} says where the vehicle was", _run.Errors.Trim());
        AssertBelow(102.04);
    }

    [Fact]
    public void Log_RecordedFlight_LocatesPixelsNearTheVehicle()
    {
        string log = TestData.PathOf("ardupilot-flight.tlog");
        (double seconds, GeodeticPosition vehicle) = PlaceOfMaxHeight(log);
        string request = _run.File("level.json", FormattableString.Invariant(
            $$"""{"groundAltitudeAmslMetres":{{vehicle.AltitudeAmslMetres - 30}},"pixel":[319.5,239.5]}"""));
        Assert.Equal(0, _run.Run(
            _camera, request, "--telemetry", log, "--time", seconds.ToString("R", CultureInfo.InvariantCulture),
            "--json"));
        NedPosition ned = LocalNedFrame.IgnoringGeoid(vehicle).ToNed(_run.Place);
        Assert.True(Math.Sqrt((ned.North * ned.North) + (ned.East * ned.East)) < 20, $"{ned.North} {ned.East}");
        Assert.Equal(1, _run.Run(_camera, request, "--telemetry", log, "--time", "1000000"));
    }

    [Fact]
    public void Log_WithoutPoses_IsBadInput()
    {
        Assert.Equal(2, _run.Run(_camera, _request, "--telemetry", _run.File("empty.tlog", ""), "--time", "1"));
        Assert.Contains("no positions", _run.Errors);
    }

    // Rolled right, the belly looks left: to the west, since the nose is north.
    private void AssertBelow(double seconds, double metres = 0.02)
    {
        NedPosition ned = World.ToNed(_run.Place);
        Assert.Equal(North(seconds), ned.North, 0.02);
        Assert.Equal(-40 * Math.Tan(Roll(seconds) * Vectors.Degree), ned.East, metres);
        Assert.Equal(500, _run.Json.Number("altitudeAmslMetres"), 0.01);
    }

    private static double North(double seconds) => 18 * (seconds - 100);

    private static double Roll(double seconds) => 2 * (seconds - 100);

    private static bool IsThere(int tenth) => tenth is <= 1050 or >= 1070;

    private string Table(string name)
    {
        var text = new StringBuilder(
            "timeSeconds,latitudeDegrees,longitudeDegrees,altitudeAmslMetres,velocityNorthMetresPerSecond,velocityEastMetresPerSecond,velocityDownMetresPerSecond,rollDegrees,pitchDegrees,yawDegrees\n");
        for (int tenth = 1000; tenth <= 1100; tenth++)
        {
            GeodeticPosition p = World.ToGeodetic(new NedPosition(North(tenth / 10.0), 0, 0));
            if (IsThere(tenth))
                text.Append(FormattableString.Invariant(
                    $"{tenth / 10.0},{p.Latitude.Degrees:R},{p.Longitude.Degrees:R},{p.AltitudeAmslMetres:R},18,0,0,{Roll(tenth / 10.0):R},0,0\n"));
        }

        return _run.File(name, text.ToString());
    }

    private string Log()
    {
        string path = _run.PathOf("log.tlog");
        using FileStream file = File.Create(path);
        var writer = new TlogWriter(file);
        Write(100, new Heartbeat { Autopilot = MavAutopilot.Invalid }, system: 9);
        Write(100, new Heartbeat { Autopilot = MavAutopilot.Ardupilotmega }, system: 1);
        for (int tenth = 1000; tenth <= 1100; tenth++)
        {
            double seconds = tenth / 10.0;
            GeodeticPosition p = World.ToGeodetic(new NedPosition(North(seconds), 0, 0));
            var place = new GlobalPositionInt
            {
                TimeBootMs = (uint)(tenth * 100),
                Lat = (int)Math.Round(p.Latitude.Degrees * DegE7),
                Lon = (int)Math.Round(p.Longitude.Degrees * DegE7),
                Alt = (int)Math.Round(p.AltitudeAmslMetres * 1000),
                Vx = 1800,
            };
            Write(seconds, place, system: 1);
            Write(
                seconds,
                new Attitude { TimeBootMs = (uint)(tenth * 100), Roll = (float)(Roll(seconds) * Vectors.Degree) },
                system: 1);

            // Another vehicle, which is none of ours.
            Write(seconds, new Attitude { TimeBootMs = (uint)(tenth * 100), Roll = 1 }, system: 9);
        }

        return path;

        void Write<T>(double seconds, T message, byte system)
            where T : struct, IMavlinkMessage
            => writer.Write(
                StampMicroseconds + (long)Math.Round(seconds * 1e6), MavlinkFrame.Create(message, system, 1, 0));
    }

    private static (double Seconds, GeodeticPosition Place) PlaceOfMaxHeight(string log)
    {
        using FileStream file = File.OpenRead(log);
        var reader = new TlogReader(file, MavlinkDialect.All);
        (double seconds, GeodeticPosition best) = (0, GeodeticPosition.FromDegrees(0, 0, -1000));
        while (reader.TryRead(out MavlinkFrame frame, out _))
        {
            if (frame.MessageId == GlobalPositionInt.MavlinkId && frame.TryDecode(out GlobalPositionInt p)
                && p.Alt / 1000.0 > best.AltitudeAmslMetres)
                (seconds, best) =
                    (p.TimeBootMs / 1000.0, GeodeticPosition.FromDegrees(p.Lat / DegE7, p.Lon / DegE7, p.Alt / 1000.0));
        }

        return (seconds, best);
    }
}
