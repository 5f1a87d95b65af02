using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Geolocate;

/// <summary>A pixel and all that is needed to find its place.</summary>
internal sealed class Request
{
    private const double MaxSeconds = 1e11;   // some 3000 years: far below what a TimeSpan holds

    private readonly PixelGeolocator _locator;
    private readonly TimeSpan _time;
    private readonly ImagingCommand _order;
    private readonly double _column;
    private readonly double _row;

    private Request(PixelGeolocator locator, TimeSpan time, ImagingCommand order, double column, double row)
        => (_locator, _time, _order, _column, _row) = (locator, time, order, column, row);

    /// <exception cref="FormatException">Something is missing or no number.</exception>
    public static Request Read(CommandLine line, TextReader input)
    {
        using JsonDocument camera = JsonDocument.Parse(File.ReadAllText(line.Camera));
        using JsonDocument request = JsonDocument.Parse(line.Request is null ? "{}" : line.Request == "-" ? input.ReadToEnd() : File.ReadAllText(line.Request));
        JsonElement asked = request.RootElement;
        RefuseOthers(asked, "the request", "pose", "gimbal", "ground_alt_m", "pixel");
        var options = new ImageProcessingOptions { Camera = CameraOf(Part(camera.RootElement, "camera")), Mount = MountOf(camera.RootElement) };
        if (line.Terrain is not null)
        {
            using var reader = new StreamReader(line.Terrain);
            options.Terrain = AsciiGrid.Read(reader);
        }

        var locator = new PixelGeolocator(options);
        TimeSpan time = TimeSpan.FromSeconds(TimeOf(line));
        if (line.Telemetry is null)
            AddPose(locator, Part(asked, "pose"));
        else
            time = Telemetry.Read(line.Telemetry, time, locator);
        bool hasGround = asked.TryGetProperty("ground_alt_m", out JsonElement ground);
        if (!hasGround && options.Terrain is null)
            throw new FormatException("The request has no ground_alt_m, and there is no --terrain.");
        bool hasGimbal = asked.TryGetProperty("gimbal", out JsonElement gimbal);
        if (hasGimbal)
            RefuseOthers(gimbal, "gimbal", "pitch_deg", "yaw_deg");
        var order = new ImagingCommand
        {
            GroundAltitudeAmslMetres = hasGround ? ground.GetDouble() : 0,
            CameraPitch = Angle.FromDegrees(hasGimbal ? Number(gimbal, "pitch_deg") : -90),
            CameraYaw = Angle.FromDegrees(hasGimbal ? Number(gimbal, "yaw_deg") : 0),
        };
        (double column, double row) = line.Pixel ?? (Numbers(asked, "pixel", 2)[0], Numbers(asked, "pixel", 2)[1]);
        return new Request(locator, time, order, column, row);
    }

    public GeolocationResult Locate() => _locator.Locate(_time, _order, _column, _row);

    private static double TimeOf(CommandLine line)
    {
        double seconds = line.TimeSeconds ?? 0;
        return Math.Abs(seconds) <= MaxSeconds
            ? seconds : throw new FormatException(FormattableString.Invariant($"--time is {seconds}; it must be seconds, {MaxSeconds} at most."));
    }

    private static CameraModel CameraOf(JsonElement camera)
    {
        double[] lens = camera.TryGetProperty("dist_k1_k2_p1_p2_k3", out _) ? Numbers(camera, "dist_k1_k2_p1_p2_k3", 5) : new double[5];
        return new CameraModel
        {
            Width = (int)Number(camera, "width"),
            Height = (int)Number(camera, "height"),
            FocalX = Number(camera, "fx"),
            FocalY = Number(camera, "fy"),
            CentreX = Number(camera, "cx"),
            CentreY = Number(camera, "cy"),
            K1 = lens[0],
            K2 = lens[1],
            P1 = lens[2],
            P2 = lens[3],
            K3 = lens[4],
            RowReadout = TimeSpan.FromTicks((long)Math.Round(Optional(camera, "row_readout_us") * 10)),
        };
    }

    // In the camera or beside it: both are met.
    private static CameraMount MountOf(JsonElement file)
    {
        if (!file.TryGetProperty("mount", out JsonElement mount) && !Part(file, "camera").TryGetProperty("mount", out mount))
            return new CameraMount();
        RefuseOthers(mount, "mount", "roll_deg", "pitch_deg", "yaw_deg", "lever_arm_body_m", "lever_arm_gimbal_m", "R_body_from_cam");
        double[] arm = Arm(mount, "lever_arm_body_m");
        double[] cameraArm = Arm(mount, "lever_arm_gimbal_m");
        Rotation? turn = null;
        if (mount.TryGetProperty("R_body_from_cam", out JsonElement rows))
            turn = Rotation.FromMatrix([.. rows.EnumerateArray().SelectMany(r => r.EnumerateArray()).Select(n => n.GetDouble())]);
        return new CameraMount
        {
            FixedBodyFromCamera = turn,
            GimbalLeverArmMetres = new BodyVector(arm[0], arm[1], arm[2]),
            CameraLeverArmMetres = new BodyVector(cameraArm[0], cameraArm[1], cameraArm[2]),
            MisalignmentRoll = Angle.FromDegrees(Optional(mount, "roll_deg")),
            MisalignmentPitch = Angle.FromDegrees(Optional(mount, "pitch_deg")),
            MisalignmentYaw = Angle.FromDegrees(Optional(mount, "yaw_deg")),
        };
    }

    private static void AddPose(PixelGeolocator locator, JsonElement pose)
    {
        RefuseOthers(pose, "pose", "lat_deg", "lon_deg", "alt_m", "vn_mps", "ve_mps", "vd_mps", "roll_deg", "pitch_deg", "yaw_deg");
        Telemetry.Add(locator, default, [
            AngleOf(pose, "lat_deg", 90), AngleOf(pose, "lon_deg", 180), Number(pose, "alt_m"),
            Optional(pose, "vn_mps"), Optional(pose, "ve_mps"), Optional(pose, "vd_mps"),
            Number(pose, "roll_deg"), Number(pose, "pitch_deg"), Number(pose, "yaw_deg")]);
    }

    // A misspelt key that is left out of account would give the wrong place.
    private static void RefuseOthers(JsonElement element, string where, params string[] known)
    {
        foreach (JsonProperty property in element.EnumerateObject())
        {
            if (!known.Contains(property.Name))
                throw new FormatException($"'{property.Name}' is no key of {where}; there are {string.Join(", ", known)}.");
        }
    }

    private static double[] Arm(JsonElement mount, string name) => mount.TryGetProperty(name, out _) ? Numbers(mount, name, 3) : new double[3];

    private static JsonElement Part(JsonElement element, string name)
        => element.TryGetProperty(name, out JsonElement part) ? part : throw new FormatException($"'{name}' is missing.");

    private static double Number(JsonElement element, string name) => Part(element, name).GetDouble();

    private static double AngleOf(JsonElement element, string name, double max)
        => Number(element, name) is var degrees && Math.Abs(degrees) <= max
            ? degrees : throw new FormatException(FormattableString.Invariant($"'{name}' is {degrees}; it must be -{max} to {max}."));

    private static double Optional(JsonElement element, string name) => element.TryGetProperty(name, out JsonElement value) ? value.GetDouble() : 0;

    private static double[] Numbers(JsonElement element, string name, int count)
    {
        double[] numbers = [.. Part(element, name).EnumerateArray().Select(n => n.GetDouble())];
        return numbers.Length == count ? numbers : throw new FormatException($"'{name}' has {numbers.Length} numbers, not {count}.");
    }
}
