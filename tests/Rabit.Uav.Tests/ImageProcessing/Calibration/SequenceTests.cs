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
using Rabit.Uav.ImageProcessing.Calibration;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

/// <summary>
/// A generated sequence of pictures with telemetry and clocks of its own, beside the repository; skipped without it.
/// </summary>
public sealed class SequenceTests(ITestOutputHelper output)
{
    // After that many seconds the bounds hold; what they are worth before the filter says itself.
    private const double SettlingSeconds = 25;
    private const double OffsetSeconds = 0.5e-3;
    private const double Drift = 2e-6;

    [SequenceFact]
    public void Timesync_RecordedAnswers_GiveOffsetAndDrift()
    {
        using JsonDocument truth = RecordedSequence.Open("truth.json");
        JsonElement rule = truth.RootElement.GetProperty("telemetry").GetProperty("clock");
        double drift = rule.Number("drift");
        var clock = new SequenceClock();
        MavlinkTimesyncFilter filter = clock.Filter;
        double[] answers = [.. RecordedSequence.Rows("timesync.csv").Select(r => r[3])];
        (double worst, double worstSettling, double worstInSigmas) = (0, 0, 0);
        for (int i = MavlinkTimesyncFilter.MinAnswers; i < answers.Length; i++)
        {
            int rows = clock.RunTo(answers[i] + 1).Count();
            Assert.True(rows > 0);
            double error = Error(answers[i]);
            worstInSigmas = Math.Max(worstInSigmas, error / filter.OffsetErrorSecondsAt(answers[i] * 1e-6));
            if (answers[i] - answers[0] < SettlingSeconds * 1e6)
                worstSettling = Math.Max(worstSettling, error);
            else
                worst = Math.Max(worst, error);
        }

        double backwards = answers.Max(Error);
        output.WriteLine(FormattableString.Invariant(
            $"offset as it goes: worst {worst * 1e3:0.000} ms, {worstSettling * 1e3:0.000} ms in the first {SettlingSeconds} s, {worstInSigmas:0.0} stated deviations; afterwards over the whole file {backwards * 1e3:0.000} ms; drift {filter.Drift * 1e6:0.0} +- {filter.DriftError * 1e6:0.0} ppm of {drift * 1e6:0.0}"));
        Assert.True(worst < OffsetSeconds, $"{worst}");
        Assert.True(backwards < OffsetSeconds, $"{backwards}");
        Assert.Equal(drift, filter.Drift, Drift);
        Assert.True(worstInSigmas < 3.5, $"{worstInSigmas}");

        double Error(double at) => Math.Abs(
            filter.OffsetSecondsAt(at * 1e-6)
                - ((((at - rule.Number("companion_ref_us")) * drift) + rule.Number("autopilot_offset_us")) * 1e-6));
    }

    [SequenceFact]
    public void Estimate_ManyObservationsOfStandingTargets_IsBetterThanTheirMean()
    {
        using JsonDocument file = RecordedSequence.Open("camera.json");
        using JsonDocument truth = RecordedSequence.Open("truth.json");
        JsonElement camera = file.RootElement.GetProperty("camera");
        double[] matrix = camera.GetProperty("mount").Each("R_body_from_cam").SelectMany(r => r.EnumerateArray())
            .Select(n => n.GetDouble()).ToArray();
        double[] arm = camera.GetProperty("mount").Numbers("lever_arm_body_m");
        var mount = new CameraMount
        {
            FixedBodyFromCamera = Rotation.FromMatrix(matrix),
            GimbalLeverArmMetres = new BodyVector(arm[0], arm[1], arm[2])
        };
        CameraModel model = RecordedSequence.ModelOf(camera);
        double ground = file.RootElement.Number("ground_alt_hae_m");
        var estimator = new BiasEstimator(model, mount, new AmslAltitude(ground), new BiasOptions
        {
            Mount = Angle.FromDegrees(1.5),
            Attitude = Angle.FromDegrees(0.7),
            Heading = Angle.FromDegrees(0.7),
            PositionMetres = 1.06,
            HeightMetres = 1.5,
            Time = TimeSpan.FromMilliseconds(1),
        });
        var single = new GroundProjector(model, mount, new ErrorBudget(), Angle.FromDegrees(5));
        Dictionary<int, JsonElement> targets = truth.RootElement.Each("targets")
            .Where(t => !t.GetProperty("moving").GetBoolean()).ToDictionary(t => t.GetProperty("id").GetInt32());
        double squares = 0;
        var mean = new Dictionary<int, (double North, double East, int Count)>();
        var world = LocalNedFrame.IgnoringGeoid(WorldOrigin(file));
        int observations = 0;
        foreach ((int id, double column, double row, Pose pose)
            in RecordedSequence.Observations(file, truth, targets.Keys))
        {
            EulerAngles attitude = pose.Attitude.ToEuler();
            Assert.True(estimator.Add(new BiasObservation
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
            GroundProjection projection = single.At(pose, new ImagingCommand { GroundAltitudeAmslMetres = ground });
            Assert.True(projection.TryProjectToGround(column, row, out GeodeticPosition place));
            (double north, double east) = Error(world, targets[id], place);
            squares += (north * north) + (east * east);
            mean.TryGetValue(id, out (double North, double East, int Count) sum);
            mean[id] = (sum.North + north, sum.East + east, sum.Count + 1);
            observations++;
        }

        BiasEstimate estimate = estimator.Estimate()!;
        double[] errors = estimate.Points.Select(p => Length(Error(world, targets[p.Key], p.Value.Position))).ToArray();
        double[] square = estimate.Points.Select(p =>
        {
            (double north, double east) = Error(world, targets[p.Key], p.Value.Position);
            return p.Value.Covariance.MahalanobisSquared(north, east);
        }).ToArray();
        double meanOfObservations = Math.Sqrt(
            mean.Values.Average(m => Math.Pow(m.North / m.Count, 2) + Math.Pow(m.East / m.Count, 2)));
        output.WriteLine(FormattableString.Invariant(
            $"{observations} observations: single RMSE {Math.Sqrt(squares / observations):0.00} m, mean of observations {meanOfObservations:0.00} m, estimated: mean {errors.Average():0.00} m, worst {errors.Max():0.00} m, Mahalanobis squared {square.Average():0.00}, chi2 {estimate.Fit.NormalisedSquare:0.00}"));
        for (BiasParameter parameter = BiasParameter.MountRoll; parameter <= BiasParameter.Down; parameter++)
        {
            bool isSeen = estimate.TryGet(parameter, out _, out double sigma);
            output.WriteLine(FormattableString.Invariant(
                $"{parameter} {estimate.BestValue(parameter):0.0000} +- {sigma:0.0000} {(isSeen ? "" : "not observed")}"));
        }

        foreach (BiasCombination combination in estimate.Unobserved)
            output.WriteLine(combination.ToString());
        Assert.True(errors.Average() < 2.0, $"mean error {errors.Average()} m");
        Assert.True(square.All(s => s < 9.21), "an ellipse does not hold its target with 99 %");
        Assert.All(
            estimate.Points.Values, p => Assert.True(p.Covariance.NorthNorth + p.Covariance.EastEast >= 1.5 * 1.5));
    }

    private static (double North, double East) Error(in LocalNedFrame world, JsonElement target, GeodeticPosition place)
    {
        double[] truth = target.Numbers("ned_m");
        NedPosition found = world.ToNed(place);
        return (truth[0] - found.North, truth[1] - found.East);
    }

    private static double Length((double North, double East) v) => Math.Sqrt((v.North * v.North) + (v.East * v.East));

    private static GeodeticPosition WorldOrigin(JsonDocument file)
    {
        JsonElement origin = file.RootElement.GetProperty("origin");
        return GeodeticPosition.FromRadians(
            origin.Radians("lat_deg"), origin.Radians("lon_deg"), origin.Number("alt_hae_m"));
    }
}
