using System;
using System.Globalization;
using System.IO;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Vision.Tests.Pictures;

namespace Rabit.Uav.Tests.Geolocate;

/// <summary>The sample Geolocate, with files in a folder of its own.</summary>
internal sealed class GeolocateRun : IDisposable
{
    private readonly SamplePictures.TemporaryFolder _folder = new();

    /// <summary>A camera that looks straight down from 40 m.</summary>
    public const string Camera = """
        {"camera":{"width":640,"height":480,"fx":530,"fy":530,"cx":319.5,"cy":239.5}}
        """;

    public const string Pose = """
        {"pose":{"lat_deg":47,"lon_deg":8,"alt_m":540,"roll_deg":0,"pitch_deg":0,"yaw_deg":0},"ground_alt_m":500,"pixel":[319.5,239.5]}
        """;

    public string Output { get; private set; } = "";

    public string Errors { get; private set; } = "";

    /// <summary>Of the last run with --json.</summary>
    public JsonElement Json => JsonDocument.Parse(Output).RootElement;

    public GeodeticPosition Place => GeodeticPosition.FromDegrees(Json.Number("lat_deg"), Json.Number("lon_deg"), Json.Number("alt_m"));

    public string File(string name, string text)
    {
        string path = PathOf(name);
        System.IO.File.WriteAllText(path, text);
        return path;
    }

    public string PathOf(string name)
    {
        Directory.CreateDirectory(_folder.Path);
        return Path.Combine(_folder.Path, name);
    }

    public int Run(params string[] arguments) => RunWith("", arguments);

    public int RunWith(string input, params string[] arguments)
    {
        using var output = new StringWriter(CultureInfo.InvariantCulture);
        using var errors = new StringWriter(CultureInfo.InvariantCulture);
        using var reader = new StringReader(input);
        int code = global::Geolocate.Program.Run(arguments, reader, output, errors);
        (Output, Errors) = (output.ToString(), errors.ToString());
        return code;
    }

    public void Dispose() => _folder.Dispose();
}
