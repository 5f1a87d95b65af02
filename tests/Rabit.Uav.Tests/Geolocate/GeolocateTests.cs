using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Tests.Geometry;
using Xunit;

namespace Rabit.Uav.Tests.Geolocate;

/// <summary>Geolocate with a pose: JSON in and out, the text for people, terrain, and what it refuses.</summary>
public sealed class GeolocateTests : IDisposable
{
    private readonly GeolocateRun _run = new();

    public void Dispose() => _run.Dispose();

    [Fact]
    public void Json_Vectors_AreLocatedOrRefusedAsTheReferenceDoes()
    {
        (int located, int refused) = (0, 0);
        foreach (JsonElement c in Vectors.Geolocation.Each("flat").Where((_, i) => i % (Vectors.AreWhole ? 10 : 2) == 0 || i > 1050))
        {
            JsonElement mount = c.GetProperty("mount");
            string request = Text($$"""
                {"pose":{"lat_deg":{{c.Number("lat")}},"lon_deg":{{c.Number("lon")}},"alt_m":{{c.Number("h")}},"roll_deg":{{c.Number("roll")}},"pitch_deg":{{c.Number("pitch")}},"yaw_deg":{{c.Number("yaw")}}},
                 "gimbal":{"pitch_deg":{{mount.Number("el")}},"yaw_deg":{{mount.Number("az")}}},"ground_alt_m":{{c.Number("ground_h")}},"pixel":[{{c.Number("u")}},{{c.Number("v")}}]}
                """);
            int code = _run.RunWith(request, _run.File("camera.json", CameraText(c)), "-", "--json");
            if (c.Text("status") == "ok")
            {
                Assert.True(code == 0, $"{c}: {_run.Output}{_run.Errors}");
                Assert.True(Vectors.Distance(c.GetProperty("target").Position(), _run.Place) < 1e-4, $"{c}");
                located++;
                continue;
            }

            Assert.Equal(2, code);
            Assert.Equal("refused", _run.Json.Text("status"));
            Assert.Equal(c.Text("reason") == "camera_below_ground" ? "CameraBelowGround" : "NearHorizon", _run.Json.Text("reason"));
            refused++;
        }

        Assert.True(located > 20 && refused > 3, $"{located} located, {refused} refused");
    }

    [Fact]
    public void Text_PixelAndPose_HasPlaceAndEllipse()
    {
        string camera = _run.File("camera.json", GeolocateRun.Camera);
        Assert.Equal(0, _run.Run(camera, _run.File("request.json", GeolocateRun.Pose)));
        Assert.Contains("47.0000000, 8.0000000", _run.Output);
        Assert.Contains("32TMT", _run.Output);
        Assert.Contains("altitude 500.00 m", _run.Output);
        Assert.Contains("95 % ellipse", _run.Output);

        // A larger column is further east, a larger row further south.
        Assert.Equal(0, _run.Run(camera, _run.PathOf("request.json"), "--pixel", "419.5", "339.5", "--json"));
        NedPosition ned = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47, 8, 540)).ToNed(_run.Place);
        Assert.Equal((-7.547, 7.547), (Math.Round(ned.North, 3), Math.Round(ned.East, 3)));
        double[] covariance = _run.Json.Numbers("cov_common_ne_m2");
        Assert.True(covariance[0] > 1 && covariance[2] > 1 && _run.Json.Number("half_major_95_m") >= _run.Json.Number("half_minor_95_m"));
    }

    [Fact]
    public void Terrain_GridWithAHole_IsMetOrRefused()
    {
        string camera = _run.File("camera.json", GeolocateRun.Camera);
        string request = _run.File("request.json", GeolocateRun.Pose);

        // 100 m about the place at 510 m, with a hole 20 to 50 m to the east.
        string grid = _run.File("grid.asc", Grid((row, column) => column is 7 or 8 ? -9999 : 510));
        Assert.Equal(0, _run.Run(camera, request, "--terrain", grid, "--json"));
        Assert.Equal(510, _run.Json.Number("alt_m"), 0.01);
        Assert.Equal(2, _run.Run(camera, _run.File("east.json", GeolocateRun.Pose.Replace("\"roll_deg\":0", "\"roll_deg\":-48")), "--terrain", grid, "--json"));
        Assert.Equal("NoTerrainData", _run.Json.Text("reason"));
        Assert.Equal(2, _run.Run(camera, _run.File("north.json", GeolocateRun.Pose.Replace("\"pitch_deg\":0", "\"pitch_deg\":75")), "--terrain", grid));
        Assert.StartsWith("refused: LeavesTerrain: ", _run.Output, StringComparison.Ordinal);
        Assert.Equal(1, _run.Run(camera, request, "--terrain", _run.File("bad.asc", "ncols 5")));
    }

    [Theory]
    [InlineData("\"roll_deg\":0", "\"roll_deg\":89", "NearHorizon")]
    [InlineData("\"alt_m\":540", "\"alt_m\":499", "CameraBelowGround")]
    [InlineData("[319.5,239.5]", "[640,10]", "OutsidePicture")]
    public void Text_NoPlace_HasTheReason(string before, string after, string reason)
    {
        Assert.Equal(2, _run.RunWith(GeolocateRun.Pose.Replace(before, after), _run.File("camera.json", GeolocateRun.Camera), "-"));
        Assert.StartsWith($"refused: {reason}: ", _run.Output, StringComparison.Ordinal);
        Assert.True(_run.Output.Trim().Length > reason.Length + 25, "no reason for people");
    }

    [Theory]
    [InlineData("There is no option --colour", "--colour")]
    [InlineData("'x' is not a number", "--pixel", "x", "1")]
    [InlineData("--pixel needs two numbers", "--pixel")]
    [InlineData("--pixel needs two numbers", "--pixel", "5")]
    [InlineData("go together", "--time", "3")]
    [InlineData("--time is Infinity; it must be seconds", "--telemetry", "poses.csv", "--time", "Infinity")]
    [InlineData("--time is 922337203684; it must be seconds", "--telemetry", "poses.csv", "--time", "922337203684")]
    [InlineData("'pose' is missing")]
    public void BadInput_IsNamedAndEndsWithOne(string message, params string[] more)
    {
        string[] arguments = [_run.File("camera.json", GeolocateRun.Camera), .. more];
        Assert.Equal(1, _run.Run(arguments));
        Assert.Contains(message, _run.Errors);
        Assert.Empty(_run.Output);
    }

    [Theory]
    [InlineData("\"lat_deg\":47", "\"lat_deg\":147", "'lat_deg' is 147; it must be -90 to 90")]
    [InlineData("\"lon_deg\":8", "\"lon_deg\":-188", "'lon_deg' is -188; it must be -180 to 180")]
    public void BadInput_PoseThatIsNowhere_IsNamed(string before, string after, string message)
    {
        Assert.Equal(1, _run.RunWith(GeolocateRun.Pose.Replace(before, after), _run.File("camera.json", GeolocateRun.Camera), "-"));
        Assert.Contains(message, _run.Errors);
    }

    [Theory]
    [InlineData("\"pixel\"", "\"gimbl\":{},\"pixel\"", "'gimbl' is no key of the request")]
    [InlineData("\"roll_deg\":0", "\"rol_deg\":3,\"roll_deg\":0", "'rol_deg' is no key of pose")]
    [InlineData("\"pixel\"", "\"gimbal\":{\"pitch\":-60},\"pixel\"", "'pitch' is no key of gimbal")]
    public void BadInput_UnknownKey_IsNamed(string before, string after, string message)
    {
        Assert.Equal(1, _run.RunWith(GeolocateRun.Pose.Replace(before, after), _run.File("camera.json", GeolocateRun.Camera), "-"));
        Assert.Contains(message, _run.Errors);
    }

    [Fact]
    public void BadInput_WrongCamera_IsNamed()
    {
        string request = _run.File("request.json", GeolocateRun.Pose);
        Assert.Equal(1, _run.Run(_run.PathOf("missing.json"), request));
        Assert.Contains("missing.json", _run.Errors);
        Assert.Equal(1, _run.Run(_run.File("camera.json", "{"), request));
        Assert.Equal(1, _run.Run(_run.File("camera.json", GeolocateRun.Camera.Replace("\"fx\":530", "\"fx\":-1")), request));
        Assert.Contains("focal length", _run.Errors);
        Assert.Equal(1, _run.Run(_run.File("camera.json", GeolocateRun.Camera), _run.File("flat.json", GeolocateRun.Pose.Replace(",\"ground_alt_m\":500", ""))));
        Assert.Contains("ground_alt_m", _run.Errors);
    }

    [Fact]
    public void Process_OwnFilesOfTheSample_PrintsAPlaceAndEndsWithItsCode()
    {
        string folder = Path.GetDirectoryName(typeof(GeolocateTests).Assembly.Location)!;
        bool isMono = Type.GetType("Mono.Runtime") is not null;
        string sample = Path.Combine(Rabit.Tests.Shared.Repository.Root, "samples", "Geolocate");
        string program = Path.Combine(folder, isMono ? "Geolocate.exe" : "Geolocate.dll");
        Assert.Equal((0, true), Start(""));
        Assert.Equal((2, true), Start("--pixel -9 0"));

        (int Code, bool HasOutput) Start(string more)
        {
            using Process process = Process.Start(new ProcessStartInfo(
                isMono ? "mono" : "dotnet", $"\"{program}\" \"{Path.Combine(sample, "camera.json")}\" \"{Path.Combine(sample, "request.json")}\" {more}")
            {
                UseShellExecute = false,
                RedirectStandardOutput = true,
            })!;
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, output.Length > 20);
        }
    }

    private static string CameraText(JsonElement c)
    {
        CameraModel camera = CameraVectors.Camera(c.GetProperty("cam").GetInt32());
        CameraMount mount = CameraVectors.Mount(c.GetProperty("mount"));
        (BodyVector a, BodyVector b) = (mount.GimbalLeverArmMetres, mount.CameraLeverArmMetres);
        JsonElement turn = c.GetProperty("mount");
        return Text($$"""
            {"camera":{"width":{{camera.Width}},"height":{{camera.Height}},"fx":{{camera.FocalX}},"fy":{{camera.FocalY}},"cx":{{camera.CentreX}},"cy":{{camera.CentreY}},
              "dist_k1_k2_p1_p2_k3":[{{camera.K1}},{{camera.K2}},{{camera.P1}},{{camera.P2}},{{camera.K3}}]},
             "mount":{"roll_deg":{{turn.Number("roll")}},"pitch_deg":{{turn.Number("pitch")}},"yaw_deg":{{turn.Number("yaw")}},
              "lever_arm_body_m":[{{a.Forward}},{{a.Right}},{{a.Down}}],"lever_arm_gimbal_m":[{{b.Forward}},{{b.Right}},{{b.Down}}]} }
            """);
    }

    private static string Grid(Func<int, int, int> height)
    {
        IEnumerable<string> rows = Enumerable.Range(0, 11).Select(r => string.Join(" ", Enumerable.Range(0, 11).Select(c => height(r, c).ToString(CultureInfo.InvariantCulture))));
        return "ncols 11\nnrows 11\nxllcenter 7.999\nyllcenter 46.9995\ndx 0.0002\ndy 0.0001\nNODATA_value -9999\n" + string.Join("\n", rows) + "\n";
    }

    private static string Text(FormattableString text) => FormattableString.Invariant(text);
}
