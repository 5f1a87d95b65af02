using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Uav.Geometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Calibration;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Geometry;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

/// <summary>A recorded sequence of pictures with telemetry and clocks of its own, beside the repository; without it these tests do nothing but say so.</summary>
public sealed class SequenceTests(ITestOutputHelper output)
{
    private static string? Folder => Vectors.FullFolder is { } autonomy && Directory.Exists(Path.Combine(autonomy, "..", "imagery", "sequence_01"))
        ? Path.Combine(autonomy, "..", "imagery", "sequence_01") : null;

    [Fact]
    public void Timesync_RecordedAnswers_GiveTheOffset()
    {
        if (IsMissing())
            return;
        using JsonDocument truth = Open("truth.json");
        JsonElement clock = truth.RootElement.GetProperty("telemetry").GetProperty("clock");
        double drift = clock.Number("drift");
        var filter = new MavlinkTimesyncFilter();
        double[][] rows = [.. Rows("timesync.csv")];
        (double worst, double squares, int count) = (0, 0, 0);
        for (int i = 0; i < rows.Length; i++)
        {
            filter.Take(Microseconds(rows[i][1]), Microseconds(rows[i][3]), rows[i][2] * 1e-6);
            if (i < 9)
                continue;
            double error = Math.Abs(filter.OffsetSecondsAt(rows[i][3] * 1e-6) - Expected(rows[i][3]));
            (worst, squares, count) = (Math.Max(worst, error), squares + (error * error), count + 1);
        }

        double middle = Math.Abs(filter.OffsetSecondsAt(rows[31][3] * 1e-6) - Expected(rows[31][3]));
        output.WriteLine(FormattableString.Invariant(
            $"offset as it goes: rms {Math.Sqrt(squares / count) * 1e3:0.000} ms, worst {worst * 1e3:0.000} ms; afterwards, in the middle {middle * 1e3:0.000} ms; drift {filter.Drift * 1e6:0.0} ppm of {drift * 1e6:0.0}"));

        // The ways vary by 3 ms: 63 answers do not hold the drift better than to some 10 ppm, which a fit that knows how they are drawn confirms.
        Assert.True(middle < 0.5e-3, $"{middle}");
        Assert.True(worst < 1e-3, $"{worst}");
        Assert.Equal(drift, filter.Drift, 15e-6);

        double Expected(double microseconds) => (((microseconds - clock.Number("companion_ref_us")) * drift) + clock.Number("autopilot_offset_us")) * 1e-6;
    }

    [Fact]
    public void Estimate_ManyLooksAtStandingTargets_IsBetterThanTheirMean()
    {
        if (IsMissing())
            return;
        using JsonDocument file = Open("camera.json");
        using JsonDocument truth = Open("truth.json");
        JsonElement camera = file.RootElement.GetProperty("camera");
        double[] matrix = camera.GetProperty("mount").Each("R_body_from_cam").SelectMany(r => r.EnumerateArray()).Select(n => n.GetDouble()).ToArray();
        double[] arm = camera.GetProperty("mount").Numbers("lever_arm_body_m");
        var mount = new CameraMount { FixedBodyFromCamera = Rotation.FromMatrix(matrix), GimbalArmMetres = new BodyVector(arm[0], arm[1], arm[2]) };
        CameraModel model = ModelOf(camera);
        double ground = file.RootElement.Number("ground_alt_hae_m");
        var estimator = new BiasEstimator(model, mount, new AmslAltitude(ground), new BiasOptions
        {
            MountRadians = 1.5 * Vectors.Degree,
            AttitudeRadians = 0.7 * Vectors.Degree,
            HeadingRadians = 0.7 * Vectors.Degree,
            PositionMetres = 1.06,
            HeightMetres = 1.5,
            Time = TimeSpan.FromMilliseconds(1),
        });
        var single = new Locator(model, mount, new ErrorBudget(), 5 * Vectors.Degree);
        Dictionary<int, JsonElement> targets = truth.RootElement.Each("targets").Where(t => !t.GetProperty("moving").GetBoolean()).ToDictionary(t => t.GetProperty("id").GetInt32());
        double squares = 0;
        var mean = new Dictionary<int, (double North, double East, int Count)>();
        var world = new LocalNedFrame(WorldOrigin(file));
        int looks = 0;
        foreach ((int id, double column, double row, Pose pose) in Looks(file, truth, targets))
        {
            EulerAngles attitude = pose.Attitude.ToEuler();
            Assert.True(estimator.Add(new BiasLook
            {
                Point = id,
                Time = pose.Time,
                Column = column,
                Row = row,
                Position = pose.Position,
                VelocityNed = pose.VelocityNed,
                Attitude = attitude,
                Rates = pose.Rates,
            }));
            single.Aim(pose, new ImagingOrder { GroundAltitudeAmslMetres = ground });
            Assert.True(single.TryLocate(column, row, out GeodeticPosition place));
            (double north, double east) = Error(world, targets[id], place);
            squares += (north * north) + (east * east);
            mean.TryGetValue(id, out (double North, double East, int Count) sum);
            mean[id] = (sum.North + north, sum.East + east, sum.Count + 1);
            looks++;
        }

        BiasEstimate estimate = estimator.Estimate()!;
        double[] errors = estimate.Points.Select(p => Length(Error(world, targets[p.Key], p.Value.Position))).ToArray();
        double[] square = estimate.Points.Select(p =>
        {
            (double north, double east) = Error(world, targets[p.Key], p.Value.Position);
            return p.Value.Covariance.MahalanobisSquared(north, east);
        }).ToArray();
        double meanOfLooks = Math.Sqrt(mean.Values.Average(m => Math.Pow(m.North / m.Count, 2) + Math.Pow(m.East / m.Count, 2)));
        output.WriteLine(FormattableString.Invariant(
            $"{looks} looks: single RMSE {Math.Sqrt(squares / looks):0.00} m, mean of looks {meanOfLooks:0.00} m, estimated: mean {errors.Average():0.00} m, worst {errors.Max():0.00} m, Mahalanobis squared {square.Average():0.00}, chi2 {estimate.Fit.NormalisedSquare:0.00}"));
        for (BiasParameter parameter = BiasParameter.MountRoll; parameter <= BiasParameter.Down; parameter++)
        {
            bool isSeen = estimate.TryGet(parameter, out _, out double sigma);
            output.WriteLine(FormattableString.Invariant($"{parameter} {estimate.BestValue(parameter):0.0000} +- {sigma:0.0000} {(isSeen ? "" : "not observed")}"));
        }

        foreach (BiasCombination combination in estimate.Unobserved)
            output.WriteLine(combination.ToString());
        Assert.True(errors.Average() < 2.0, $"mean error {errors.Average()} m");
        Assert.True(square.All(s => s < 9.21), "an ellipse does not hold its target with 99 %");
        Assert.All(estimate.Points.Values, p => Assert.True(p.Covariance.NorthNorth + p.Covariance.EastEast >= 1.5 * 1.5));
    }

    private IEnumerable<(int Id, double Column, double Row, Pose Pose)> Looks(JsonDocument file, JsonDocument truth, Dictionary<int, JsonElement> standing)
    {
        var history = new PoseHistory(TimeSpan.FromSeconds(1));
        var filter = new MavlinkTimesyncFilter();
        double[][] answers = [.. Rows("timesync.csv")];
        double[][] rows = [.. Rows("telemetry.csv")];
        (int answer, int next) = (0, 0);
        foreach ((JsonElement frame, JsonElement seen) in file.RootElement.Each("frames").Zip(truth.RootElement.Each("frames"), (f, t) => (f, t)))
        {
            TimeSpan middle = Microseconds(frame.Number("frame_start_us") + (frame.Number("exposure_us") / 2));
            double until = (middle.TotalSeconds * 1e6) + 300_000;
            for (; answer < answers.Length && (answers[answer][3] < until || answer < 5); answer++)
                filter.Take(Microseconds(answers[answer][1]), Microseconds(answers[answer][3]), answers[answer][2] * 1e-6);
            for (; next < rows.Length && rows[next][1] < until; next++)
                AddPose(history, filter, rows[next]);
            Assert.Equal(PoseAnswer.Known, history.Find(middle, out Pose pose));
            foreach (JsonElement target in seen.Each("targets"))
            {
                int id = target.GetProperty("id").GetInt32();
                if (!standing.ContainsKey(id) || target.Number("fraction_visible") < 0.5)
                    continue;
                double[] centre = target.Numbers("center_px");
                yield return (id, centre[0], centre[1], pose);
            }
        }
    }

    private static void AddPose(PoseHistory history, MavlinkTimesyncFilter filter, double[] row)
    {
        TimeSpan time = TimeSpan.FromTicks((long)Math.Round(((row[0] * 1e-6) - filter.OffsetSecondsAt(row[1] * 1e-6)) * TimeSpan.TicksPerSecond));
        history.Add(new PoseSample
        {
            Kind = PoseSampleKind.Position,
            Time = time,
            Position = new GeodeticPosition(row[2] * Vectors.Degree, row[3] * Vectors.Degree, row[4]),
            VelocityNed = new NedVector(row[5], row[6], row[7]),
        });
        history.Add(new PoseSample
        {
            Kind = PoseSampleKind.Attitude,
            Time = time,
            Attitude = new EulerAngles(row[8] * Vectors.Degree, row[9] * Vectors.Degree, row[10] * Vectors.Degree),
            Rates = new BodyRates(row[11] * Vectors.Degree, row[12] * Vectors.Degree, row[13] * Vectors.Degree),
        });
    }

    private bool IsMissing()
    {
        if (Folder is null)
            output.WriteLine("skipped: vectors/imagery/sequence_01 is not beside the repository");
        return Folder is null;
    }

    private static (double North, double East) Error(in LocalNedFrame world, JsonElement target, GeodeticPosition place)
    {
        double[] truth = target.Numbers("ned_m");
        NedVector found = world.ToNed(place);
        return (truth[0] - found.North, truth[1] - found.East);
    }

    private static double Length((double North, double East) v) => Math.Sqrt((v.North * v.North) + (v.East * v.East));

    private static GeodeticPosition WorldOrigin(JsonDocument file)
    {
        JsonElement origin = file.RootElement.GetProperty("origin");
        return new GeodeticPosition(origin.Radians("lat_deg"), origin.Radians("lon_deg"), origin.Number("alt_hae_m"));
    }

    private static CameraModel ModelOf(JsonElement camera)
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

    private static TimeSpan Microseconds(double microseconds) => TimeSpan.FromTicks((long)Math.Round(microseconds * 10));

    private static JsonDocument Open(string name) => JsonDocument.Parse(File.ReadAllText(Path.Combine(Folder!, name)));

    private static IEnumerable<double[]> Rows(string name) => File.ReadLines(Path.Combine(Folder!, name)).Skip(1)
        .Select(line => line.Split(',').Select(n => double.Parse(n, CultureInfo.InvariantCulture)).ToArray());
}
