using System;
using System.Globalization;
using System.IO;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;

namespace Rabit.Tool.Tests.Geolocate;

/// <summary><c>rabit geolocate</c>, with files in a folder of its own.</summary>
internal sealed class GeolocateFiles : IDisposable
{
    private const string ErrorPrefix = "rabit geolocate: ";

    private readonly string _folder = Path.Combine(Path.GetTempPath(), "rabit-" + Guid.NewGuid().ToString("N"));

    /// <summary>A camera that looks straight down from 40 m.</summary>
    public const string Camera = """
        {"camera":{"width":640,"height":480,"fx":530,"fy":530,"cx":319.5,"cy":239.5,
          "distortion":[0,0,0,0,0],"mount":{"leverArmBodyMetres":[0,0,0],"gimbal":{}}}}
        """;

    public const string Pose = """
        {"pose":{"latitudeDegrees":47,"longitudeDegrees":8,"altitudeAmslMetres":540,"rollDegrees":0,"pitchDegrees":0,"yawDegrees":0},"groundAltitudeAmslMetres":500,"pixel":[319.5,239.5]}
        """;

    public string Output { get; private set; } = "";

    /// <summary>Without the name of the command, with which every line begins.</summary>
    public string Errors { get; private set; } = "";

    /// <summary>Of the last run with --json.</summary>
    public JsonElement Json => JsonDocument.Parse(Output).RootElement;

    public GeodeticPosition Place
        => GeodeticPosition.FromDegrees(
            Json.Number("latitudeDegrees"), Json.Number("longitudeDegrees"), Json.Number("altitudeAmslMetres"));

    public string File(string name, string text)
    {
        string path = PathOf(name);
        System.IO.File.WriteAllText(path, text);
        return path;
    }

    public string PathOf(string name)
    {
        Directory.CreateDirectory(_folder);
        return Path.Combine(_folder, name);
    }

    public int Run(params string[] arguments) => RunWith("", arguments);

    public int RunWith(string input, params string[] arguments)
    {
        using var output = new StringWriter(CultureInfo.InvariantCulture);
        using var errors = new StringWriter(CultureInfo.InvariantCulture);
        using var reader = new StringReader(input);
        var console = new ToolConsole { Input = reader, Output = output, Error = errors };
        int code = CommandLine.Run(["geolocate", .. arguments], console);
        Output = output.ToString();
        Errors = errors.ToString();
        if (Errors.Length > 0)
        {
            Assert.StartsWith(ErrorPrefix, Errors, StringComparison.Ordinal);
            Errors = Errors.Substring(ErrorPrefix.Length);
        }

        return code;
    }

    public void Dispose()
    {
        if (Directory.Exists(_folder))
            Directory.Delete(_folder, recursive: true);
    }
}
