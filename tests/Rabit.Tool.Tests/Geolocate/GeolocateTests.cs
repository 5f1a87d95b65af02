using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Tool.Geolocation;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Tests.Geometry;
using Xunit;

namespace Rabit.Tool.Tests.Geolocate;

/// <summary><c>rabit geolocate</c> with a pose: JSON in and out, text, terrain, and what it refuses.</summary>
public sealed class GeolocateTests : IDisposable
{
    private readonly GeolocateFiles _run = new();

    public void Dispose() => _run.Dispose();

    [Fact]
    public void Json_Vectors_AreLocatedOrRefusedAsTheReferenceDoes()
    {
        (int located, int refused) = (0, 0);
        foreach (JsonElement c
            in Vectors.Geolocation.Each("flat").Where((_, i) => i % (Vectors.AreWhole ? 10 : 2) == 0 || i > 1050))
        {
            JsonElement mount = c.GetProperty("mount");
            string request = Text($$"""
                {"pose":{"latitudeDegrees":{{c.Number("lat")}},"longitudeDegrees":{{c.Number("lon")}},"altitudeAmslMetres":{{c.Number("h")}},"rollDegrees":{{c.Number("roll")}},"pitchDegrees":{{c.Number("pitch")}},"yawDegrees":{{c.Number("yaw")}}},
                 "gimbal":{"pitchDegrees":{{mount.Number("el")}},"yawDegrees":{{mount.Number("az")}}},"groundAltitudeAmslMetres":{{c.Number("ground_h")}},"pixel":[{{c.Number("u")}},{{c.Number("v")}}]}
                """);
            int code = _run.RunWith(request, _run.File("camera.json", CameraText(c)), "-", "--json");
            if (c.Text("status") == "ok")
            {
                Assert.True(code == 0, $"{c}: {_run.Output}{_run.Errors}");
                Assert.True(Vectors.Distance(c.GetProperty("target").Position(), _run.Place) < 1e-4, $"{c}");
                located++;
                continue;
            }

            Assert.Equal(1, code);
            Assert.Equal("refused", _run.Json.Text("status"));
            Assert.Equal(
                c.Text("reason") == "camera_below_ground" ? "CameraBelowGround" : "NearHorizon",
                _run.Json.Text("reason"));
            refused++;
        }

        Assert.True(located > 20 && refused > 3, $"{located} located, {refused} refused");
    }

    [Fact]
    public void Text_PixelAndPose_GivesPlaceAndEllipse()
    {
        string camera = _run.File("camera.json", GeolocateFiles.Camera);
        Assert.Equal(0, _run.Run(camera, _run.File("request.json", GeolocateFiles.Pose)));
        Assert.Contains("47.0000000, 8.0000000", _run.Output);
        Assert.Contains("32TMT", _run.Output);
        Assert.Contains("altitude 500.00 m", _run.Output);
        Assert.Contains("95 % ellipse", _run.Output);

        // A larger column is further east, a larger row further south.
        Assert.Equal(0, _run.Run(camera, _run.PathOf("request.json"), "--pixel", "419.5", "339.5", "--json"));
        NedPosition ned = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47, 8, 540)).ToNed(_run.Place);
        Assert.Equal((-7.547, 7.547), (Math.Round(ned.North, 3), Math.Round(ned.East, 3)));
        double[] covariance = _run.Json.Numbers("systematicCovarianceSquareMetres");
        Assert.True(covariance[0] > 1 && covariance[2] > 1
            && _run.Json.Number("ellipse95HalfMajorAxisMetres") >= _run.Json.Number("ellipse95HalfMinorAxisMetres"));
    }

    [Fact]
    public void Camera_FixedAndTiltedForward_LooksNorthOfTheVehicle()
    {
        // 45 degrees up from straight down: what lies 40 m ahead is on the optical axis.
        string camera = _run.File("camera.json", GeolocateFiles.Camera.Replace(
            "\"gimbal\":{}",
            "\"bodyFromCamera\":[[0,-0.70710678118654752,0.70710678118654752],[1,0,0],[0,0.70710678118654752,0.70710678118654752]]"));
        Assert.Equal(0, _run.RunWith(GeolocateFiles.Pose, camera, "-", "--json"));
        NedPosition ned = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47, 8, 540)).ToNed(_run.Place);
        Assert.Equal((40, 0), (Math.Round(ned.North, 3), Math.Round(ned.East, 3) + 0.0));
    }

    [Fact]
    public void Terrain_GridWithAHole_IsMetOrRefused()
    {
        string camera = _run.File("camera.json", GeolocateFiles.Camera);
        string request = _run.File("request.json", GeolocateFiles.Pose);

        // 100 m about the place at 510 m, with a hole 20 to 50 m to the east.
        string grid = _run.File("grid.asc", Grid((row, column) => column is 7 or 8 ? -9999 : 510));
        Assert.Equal(0, _run.Run(camera, request, "--terrain", grid, "--json"));
        Assert.Equal(510, _run.Json.Number("altitudeAmslMetres"), 0.01);
        Assert.Equal(1, _run.Run(
            camera, _run.File("east.json", GeolocateFiles.Pose.Replace("\"rollDegrees\":0", "\"rollDegrees\":-48")),
            "--terrain", grid, "--json"));
        Assert.Equal("NoTerrainData", _run.Json.Text("reason"));
        Assert.Equal(1, _run.Run(
            camera, _run.File("north.json", GeolocateFiles.Pose.Replace("\"pitchDegrees\":0", "\"pitchDegrees\":75")),
            "--terrain", grid));
        Assert.StartsWith("refused: LeavesTerrain: ", _run.Output, StringComparison.Ordinal);
        Assert.Equal(2, _run.Run(camera, request, "--terrain", _run.File("bad.asc", "ncols 5")));
    }

    [Theory]
    [InlineData("\"rollDegrees\":0", "\"rollDegrees\":89", "NearHorizon")]
    [InlineData("\"altitudeAmslMetres\":540", "\"altitudeAmslMetres\":499", "CameraBelowGround")]
    [InlineData("[319.5,239.5]", "[640,10]", "OutsidePicture")]
    public void Text_NoPlace_GivesTheReason(string before, string after, string reason)
    {
        Assert.Equal(
            1,
            _run.RunWith(GeolocateFiles.Pose.Replace(before, after), _run.File("camera.json", GeolocateFiles.Camera), "-"));
        Assert.StartsWith($"refused: {reason}: ", _run.Output, StringComparison.Ordinal);
        Assert.True(_run.Output.Trim().Length > reason.Length + 25, "no reason for people");
    }

    [Theory]
    [InlineData("'--colour' is no option.", "--colour")]
    [InlineData("'x' is not a number", "--pixel", "x", "1")]
    [InlineData("--pixel needs two numbers", "--pixel")]
    [InlineData("--pixel needs two numbers", "--pixel", "5")]
    [InlineData("--pixel needs two numbers", "--pixel", "1,2", "--pixel")]
    [InlineData("--pixel needs two numbers", "--pixel", "--pixel", "1,2")]
    [InlineData("--pixel needs two numbers", "--pixel", "1,2", "--pixel", "3", "--json")]
    [InlineData("'NaN' is not a number", "--pixel", "NaN,1")]
    [InlineData("Required argument missing for option: '--geojson'", "--geojson")]
    [InlineData("go together", "--time", "3")]
    [InlineData("--time is Infinity, which is not finite", "--telemetry", "poses.csv", "--time", "Infinity")]
    [InlineData("--time is 922337203684; it must be seconds", "--telemetry", "poses.csv", "--time", "922337203684")]
    [InlineData("the request: pose is missing")]
    public void BadInput_IsNamedAndEndsWithTwo(string message, params string[] more)
    {
        string[] arguments = [_run.File("camera.json", GeolocateFiles.Camera), .. more];
        Assert.Equal(2, _run.Run(arguments));
        Assert.Contains(message, _run.Errors);
        Assert.Empty(_run.Output);
    }

    [Theory]
    [InlineData("\"latitudeDegrees\":47", "\"latitudeDegrees\":147",
        "pose.latitudeDegrees is 147; it must be -90 to 90")]
    [InlineData("\"longitudeDegrees\":8", "\"longitudeDegrees\":-188",
        "pose.longitudeDegrees is -188; it must be -180 to 180")]
    [InlineData("\"altitudeAmslMetres\":540", "\"altitudeAmslMetres\":1e9",
        "pose.altitudeAmslMetres is 1e9; it must be -1000 to 100000")]
    [InlineData("\"rollDegrees\":0", "\"rollDegrees\":0,\"velocityNorthMetresPerSecond\":1e306",
        "pose.velocityNorthMetresPerSecond is 1e306; it must be -10000 to 10000")]
    [InlineData("\"rollDegrees\":0", "\"rollDegrees\":181", "pose.rollDegrees is 181; it must be -180 to 180")]
    [InlineData("\"yawDegrees\":0", "\"yawDegrees\":-361", "pose.yawDegrees is -361; it must be -360 to 360")]
    [InlineData("\"groundAltitudeAmslMetres\":500", "\"groundAltitudeAmslMetres\":10001",
        "groundAltitudeAmslMetres is 10001; it must be -1000 to 10000")]
    [InlineData("\"pixel\"", "\"gimbal\":{\"pitchDegrees\":-181,\"yawDegrees\":0},\"pixel\"",
        "gimbal.pitchDegrees is -181; it must be -180 to 180")]
    [InlineData("\"pixel\"", "\"gimbl\":{},\"pixel\"",
        "gimbl is unknown; there are pose, gimbal, groundAltitudeAmslMetres, pixel, pixels")]
    [InlineData("\"rollDegrees\":0", "\"rolDegrees\":3,\"rollDegrees\":0", "pose.rolDegrees is unknown")]
    [InlineData("\"rollDegrees\":0", "\"rollDegrees\":3,\"rollDegrees\":0", "pose.rollDegrees is there twice")]
    [InlineData("\"pixel\"", "\"gimbal\":{\"pitch\":-60},\"pixel\"",
        "gimbal.pitch is unknown; there are rollDegrees, pitchDegrees, yawDegrees")]
    [InlineData("\"rollDegrees\":0", "\"rollDegrees\":\"0\"", "pose.rollDegrees is \"0\"; it must be a number")]
    [InlineData("\"rollDegrees\":0", "\"rollDegrees\":null", "pose.rollDegrees is null; it must be a number")]
    [InlineData("[319.5,239.5]", "[319.5]", "pixel is [319.5]; it must be a list of two numbers")]
    [InlineData("[319.5,239.5]", "[319.5,true]", "pixel[1] is true; it must be a number")]
    [InlineData("\"pixel\"", "\"gimbal\":[1],\"pixel\"", "gimbal is [1]; it must be an object")]
    [InlineData(",\"groundAltitudeAmslMetres\":500", "", "groundAltitudeAmslMetres is missing")]
    [InlineData("\"yawDegrees\":0}", "\"yawDegrees\":0", "it is not JSON")]
    public void BadInput_Request_NamesFileAndFieldInOneLine(string before, string after, string message)
    {
        Assert.Contains(before, GeolocateFiles.Pose, StringComparison.Ordinal);
        string request = _run.File("request.json", GeolocateFiles.Pose.Replace(before, after));

        Assert.Equal(2, _run.Run(_run.File("camera.json", GeolocateFiles.Camera), request));

        Assert.StartsWith(request + ": " + message, _run.Errors, StringComparison.Ordinal);
        Assert.Single(_run.Errors.TrimEnd().Split('\n'));
    }

    [Theory]
    [InlineData("latitudeDegrees", "lat_deg",
        "pose.lat_deg is of an older form of the file; it is pose.latitudeDegrees now")]
    [InlineData("yawDegrees", "yaw_deg", "pose.yaw_deg is of an older form of the file; it is pose.yawDegrees now")]
    [InlineData("groundAltitudeAmslMetres", "ground_alt_m",
        "ground_alt_m is of an older form of the file; it is groundAltitudeAmslMetres now")]
    public void BadInput_NameOfTheOldForm_IsRefusedWithTheNewOne(string now, string old, string message)
    {
        Assert.Equal(
            2, _run.RunWith(GeolocateFiles.Pose.Replace(now, old), _run.File("camera.json", GeolocateFiles.Camera), "-"));
        Assert.Equal("the standard input: " + message, _run.Errors.TrimEnd());
    }

    [Theory]
    [InlineData("\"fx\":530", "\"fx\":-1", "focal length")]
    [InlineData("\"fx\":530", "\"fx\":\"530\"", "camera.fx is \"530\"; it must be a number")]
    [InlineData("distortion", "dist_k1_k2_p1_p2_k3", "it is camera.distortion now")]
    [InlineData("\"gimbal\":{}", "\"gimbal\":{\"roll_deg\":1}",
        "it is camera.mount.gimbal.misalignmentRollDegrees now")]
    [InlineData(",\"gimbal\":{}", "", "camera.mount.bodyFromCamera is missing")]
    [InlineData("{\"camera\"", "\"camera\"", "it is not JSON")]
    public void BadInput_Camera_NamesFileAndFieldInOneLine(string before, string after, string message)
    {
        Assert.Contains(before, GeolocateFiles.Camera, StringComparison.Ordinal);
        string camera = _run.File("camera.json", GeolocateFiles.Camera.Replace(before, after));

        Assert.Equal(2, _run.RunWith(GeolocateFiles.Pose, camera, "-"));

        Assert.StartsWith(camera + ": ", _run.Errors, StringComparison.Ordinal);
        Assert.Contains(message, _run.Errors);
        Assert.Single(_run.Errors.TrimEnd().Split('\n'));
    }

    [Fact]
    public void BadInput_FileThatIsNotThere_IsNamed()
    {
        Assert.Equal(2, _run.RunWith(GeolocateFiles.Pose, _run.PathOf("missing.json"), "-"));
        Assert.Contains("missing.json: no such file", _run.Errors);
        string camera = _run.File("camera.json", GeolocateFiles.Camera);
        Assert.Equal(2, _run.Run(camera, _run.PathOf("missing.json")));
        Assert.Contains("missing.json", _run.Errors);
        Assert.Equal(2, _run.RunWith(GeolocateFiles.Pose, camera, "-", "--terrain", _run.File("bad.asc", "ncols 5")));
        Assert.Contains("bad.asc: ", _run.Errors);
        Assert.Equal(2, _run.RunWith(GeolocateFiles.Pose, camera, "-", "--terrain", _run.PathOf("none.asc")));
        Assert.StartsWith(_run.PathOf("none.asc") + ": ", _run.Errors);
    }

    [Theory]
    [InlineData("", "pipe", "request.json")]
    [InlineData("; - reads the standard input", "camera.json", "pipe")]
    [InlineData("", "pipe.jpg", "--pixel", "1,1")]
    [InlineData("", "camera.json", "request.json", "--telemetry", "pipe.tlog", "--time", "1")]
    [InlineData("", "camera.json", "request.json", "--telemetry", "pipe", "--time", "1")]
    [InlineData("", "camera.json", "request.json", "--terrain", "pipe")]
    [InlineData("", "camera.json", "request.json", "--geojson", "pipe")]
    public void BadInput_NamedPipe_IsRefusedAndNotWaitedFor(string hint, params string[] arguments)
    {
        if (!Directory.Exists("/proc/self"))
            return;   // named pipes are looked for on Linux
        _run.File("camera.json", GeolocateFiles.Camera);
        _run.File("request.json", GeolocateFiles.Pose);
        string pipe = _run.PathOf(Array.Find(arguments, a => a.StartsWith("pipe", StringComparison.Ordinal))!);
        Assert.Equal(0, ToolProcess.RunInShell($"mkfifo \"{pipe}\"").ExitCode);
        string[] inFolder = [.. arguments.Select(
            a => a.Contains("json") && !a.StartsWith("--", StringComparison.Ordinal) ? _run.PathOf(a)
                : a.StartsWith("pipe", StringComparison.Ordinal) ? pipe : a)];

        Assert.Equal(2, _run.Run(inFolder));

        Assert.Equal($"{pipe}: it is a pipe, not a file{hint}.", _run.Errors.Trim());
    }

    [Fact]
    public void Help_NamesEveryFieldOfAPose()
    {
        Assert.Equal(0, _run.Run("--help"));
        Assert.All(PoseField.All.Select(f => f.Name), n => Assert.Contains(n, _run.Output));
    }

    [Fact]
    public void Process_FilesOfTheDocument_PrintsAPlaceOrRefuses()
    {
        string folder = Path.Combine(Rabit.Tests.Shared.Repository.Root, "docs", "examples", "geolocate");
        string[] files = [Path.Combine(folder, "camera.json"), Path.Combine(folder, "request.json")];

        ToolProcess place = ToolProcess.Run(["geolocate", .. files]);
        Assert.Equal((0, 0), (place.ExitCode, place.Errors.Count));
        Assert.StartsWith("47.39", place.Output[0], StringComparison.Ordinal);

        ToolProcess refused = ToolProcess.Run(["geolocate", .. files, "--pixel", "-9", "0"]);
        Assert.Equal((1, 0), (refused.ExitCode, refused.Errors.Count));
        Assert.StartsWith("refused: OutsidePicture", refused.Output[0], StringComparison.Ordinal);
    }

    private static string CameraText(JsonElement c)
    {
        CameraModel camera = CameraVectors.Camera(c.GetProperty("cam").GetInt32());
        CameraMount mount = CameraVectors.Mount(c.GetProperty("mount"));
        (BodyVector a, BodyVector b) = (mount.GimbalLeverArmMetres, mount.CameraLeverArmMetres);
        JsonElement turn = c.GetProperty("mount");
        return Text($$"""
            {"camera":{"width":{{camera.Width}},"height":{{camera.Height}},"fx":{{camera.FocalX}},"fy":{{camera.FocalY}},"cx":{{camera.CentreX}},"cy":{{camera.CentreY}},
              "distortion":[{{camera.K1}},{{camera.K2}},{{camera.P1}},{{camera.P2}},{{camera.K3}}],
              "mount":{"leverArmBodyMetres":[{{a.Forward}},{{a.Right}},{{a.Down}}],
               "gimbal":{"misalignmentRollDegrees":{{turn.Number("roll")}},"misalignmentPitchDegrees":{{turn.Number("pitch")}},
                "misalignmentYawDegrees":{{turn.Number("yaw")}},"leverArmGimbalMetres":[{{b.Forward}},{{b.Right}},{{b.Down}}]} } } }
            """);
    }

    private static string Grid(Func<int, int, int> height)
    {
        IEnumerable<string> rows = Enumerable.Range(0, 11).Select(
            r => string.Join(
                " ", Enumerable.Range(0, 11).Select(c => height(r, c).ToString(CultureInfo.InvariantCulture))));
        return "ncols 11\nnrows 11\nxllcenter 7.999\nyllcenter 46.9995\ndx 0.0002\ndy 0.0001\nNODATA_value -9999\n"
            + string.Join("\n", rows) + "\n";
    }

    private static string Text(FormattableString text) => FormattableString.Invariant(text);
}
