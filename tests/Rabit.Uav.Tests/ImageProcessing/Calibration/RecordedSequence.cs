using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Mavlink;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

/// <summary>The files of a generated sequence of pictures, with telemetry and clocks of their own.</summary>
internal static class RecordedSequence
{
    /// <summary>Null where it is not beside the repository.</summary>
    public static string? Folder { get; } = Vectors.FolderOf(Path.Combine("imagery", "sequence_01"));

    public static JsonDocument Open(string name) => JsonDocument.Parse(File.ReadAllText(Path.Combine(Folder!, name)));

    public static double[][] Rows(string name) => [.. File.ReadLines(Path.Combine(Folder!, name)).Skip(1)
        .Select(line => line.Split(',').Select(n => double.Parse(n, CultureInfo.InvariantCulture)).ToArray())];

    public static TimeSpan Microseconds(double microseconds) => TimeSpan.FromTicks((long)Math.Round(microseconds * 10));

    public static CameraModel ModelOf(JsonElement camera)
    {
        double[] d = camera.Numbers("dist_k1_k2_p1_p2_k3");
        return new CameraModel
        {
            Width = camera.GetProperty("width").GetInt32(),
            Height = camera.GetProperty("height").GetInt32(),
            FocalX = camera.Number("fx"),
            FocalY = camera.Number("fy"),
            CentreX = camera.Number("cx"),
            CentreY = camera.Number("cy"),
            K1 = d[0],
            K2 = d[1],
            P1 = d[2],
            P2 = d[3],
            K3 = d[4],
        };
    }

    /// <summary>
    /// The poses at each observation of one of the standing targets, as clocks and telemetry have them.
    /// </summary>
    public static IEnumerable<(int Id, double Column, double Row, Pose Pose)> Observations(
        JsonDocument file, JsonDocument truth, ICollection<int> standing)
    {
        var history = new PoseHistory(TimeSpan.FromSeconds(1));
        var clock = new SequenceClock();
        foreach ((JsonElement frame, JsonElement seen)
            in file.RootElement.Each("frames").Zip(truth.RootElement.Each("frames"), (f, t) => (f, t)))
        {
            TimeSpan middle = Microseconds(frame.Number("frame_start_us") + (frame.Number("exposure_us") / 2));
            foreach (double[] row in clock.RunTo((middle.TotalSeconds * 1e6) + 300_000))
                AddPose(history, clock.Filter, row);
            if (history.Find(middle, out Pose pose) != PoseLookup.Known)
                throw new InvalidOperationException($"There is no pose for {frame}.");
            foreach (JsonElement target in seen.Each("targets"))
            {
                int id = target.GetProperty("id").GetInt32();
                if (!standing.Contains(id) || target.Number("fraction_visible") < 0.5)
                    continue;
                double[] centre = target.Numbers("center_px");
                yield return (id, centre[0], centre[1], pose);
            }
        }
    }

    private static void AddPose(PoseHistory history, MavlinkTimesyncFilter filter, double[] row)
    {
        TimeSpan time = TimeSpan.FromTicks(
            (long)Math.Round(((row[0] * 1e-6) - filter.OffsetSecondsAt(row[1] * 1e-6)) * TimeSpan.TicksPerSecond));
        history.Add(new PoseSample
        {
            Kind = PoseSampleKind.Position,
            Time = time,
            Position = GeodeticPosition.FromDegrees(row[2], row[3], row[4]),
            VelocityNed = new NedVector(row[5], row[6], row[7]),
        });
        history.Add(new PoseSample
        {
            Kind = PoseSampleKind.Attitude,
            Time = time,
            Attitude = EulerAngles.FromDegrees(row[8], row[9], row[10]),
            Rates = BodyRates.FromDegreesPerSecond(row[11], row[12], row[13]),
        });
    }
}
