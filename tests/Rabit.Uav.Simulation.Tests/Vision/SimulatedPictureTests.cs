using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation.Tests.Camera;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>
/// The pictures of the simulated camera through Image Processing, with true poses: what is left is the error of
/// pictures, detector and geometry, which were written apart from each other.
/// </summary>
public sealed class SimulatedPictureTests(ITestOutputHelper output)
{
    // The corners of a observation are the truth, but a panel near its edge may be cut.
    private const double EdgeMetres = 1.3;

    // Measured: 111 of 127 and 127 of 130 with moderate effects, 122 of 122 and 128 of 128 at -45 degrees, none wrong.
    private const double MinRecallWithEffects = 0.85;
    private const double MinRecallAt45Degrees = 0.98;
    private const int MaxWrongWithEffects = 1;

    [Theory]
    [InlineData(1, 40)]
    [InlineData(2, 40)]
    [InlineData(3, 25)]
    [InlineData(4, 60)]
    public void Survey_TruePoses_EveryTargetInEveryPictureIsReportedWhereItIs(int seed, double height)
    {
        Survey survey = Fly((ulong)seed, height);
        double groundSample = height / 530;

        (int expected, int found, double squares, double worst) = (0, 0, 0, 0);
        var missed = new List<string>();
        foreach (CameraObservation observation in survey.Sink.Observations)
        {
            foreach (SimulatedTarget target
                in survey.Things.Where(t => !t.IsDistractor && survey.IsInside(observation, t, EdgeMetres)))
            {
                expected++;
                double[] errors = survey.Sink.Reports
                    .Where(r => r.PictureNumber == observation.Number && r.Class == target.Class)
                    .Select(r => survey.ErrorOf(r, target)).Where(e => e < 1).ToArray();
                if (errors.Length != 1)
                {
                    missed.Add($"{target.Name} in observation {observation.Number}: {errors.Length} reports");
                    continue;
                }

                found++;
                squares += errors[0] * errors[0];
                worst = Math.Max(worst, errors[0]);
            }
        }

        string[] wrong = survey.Sink.Reports
            .Where(r => !survey.Things.Any(t => !t.IsDistractor && t.Class == r.Class && survey.ErrorOf(r, t) < 1))
            .Select(r => survey.Describe(r)).ToArray();
        double rms = Math.Sqrt(squares / Math.Max(1, found));
        output.WriteLine($"seed {seed}, {height} m: {survey.Sink.Observations.Count} observations, {found} of "
            + $"{expected} found, {wrong.Length} wrong, rms {rms:F3} m, worst {worst:F3} m");
        foreach (string line in missed.Concat(wrong).Take(30))
            output.WriteLine(line);

        Assert.True(expected > 50, $"{expected} targets in view are too few to decide");
        Assert.True(found >= 0.98 * expected, $"seed {seed}: {expected - found} of {expected} sights were missed");
        Assert.True(
            wrong.Length == 0, $"seed {seed}: {wrong.Length} reports of nothing, first {wrong.FirstOrDefault()}");
        Assert.True(rms < (0.25 * groundSample) + 0.1, $"seed {seed}: off by {rms} m");
    }

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(ManySeeds))]
    public void Survey_ManySeeds_EveryTargetInEveryPictureIsReportedWhereItIs(int seed, double height)
        => Survey_TruePoses_EveryTargetInEveryPictureIsReportedWhereItIs(seed, height);

    public static TheoryData<int, double> ManySeeds()
    {
        var cases = new TheoryData<int, double>();
        for (int seed = 5; seed <= 24; seed++)
            cases.Add(seed, 20 + (seed * 3 % 50));
        return cases;
    }

    // At 30 m, with a camera that is exposed for 6 ms: the recall of the default detector with all effects.
    [Theory, Trait("Category", "Long")]
    [InlineData(1)]
    [InlineData(2)]
    public void Survey_ModerateEffects_KeepsItsRecall(int seed)
    {
        Survey survey = Fly((ulong)seed, 30, c =>
        {
            c.Exposure = TimeSpan.FromMilliseconds(6);
            c.Effects = SimulatedPictureEffects.CreateModerate();
        });

        SurveyCount count = survey.Count(EdgeMetres, minPixels: 0);
        output.WriteLine($"seed {seed}, moderate effects: {count}");
        Assert.True(count.Expected > 50, $"{count.Expected} targets in view are too few to decide");
        Assert.True(count.Found >= MinRecallWithEffects * count.Expected, $"seed {seed}: {count}");
        Assert.True(count.Wrong <= MaxWrongWithEffects, $"seed {seed}: {count}");
    }

    // From 25 m; of the panels that are seen at 6 px across and more.
    [Theory, Trait("Category", "Long")]
    [InlineData(4)]
    public void Survey_CameraAt45DegreesOfOtherSeeds_KeepsItsRecall(int seed)
        => Survey_CameraAt45Degrees_KeepsItsRecall(seed);

    [Theory]
    [InlineData(3)]
    public void Survey_CameraAt45Degrees_KeepsItsRecall(int seed)
    {
        Survey survey = Fly((ulong)seed, 25, _ => { }, pitchDegrees: -45);

        SurveyCount count = survey.Count(EdgeMetres, minPixels: 6);
        output.WriteLine($"seed {seed}, -45 degrees: {count}");
        Assert.True(count.Expected > 50, $"{count.Expected} targets in view are too few to decide");
        Assert.True(count.Found >= MinRecallAt45Degrees * count.Expected, $"seed {seed}: {count}");
        Assert.True(count.Wrong <= MaxWrongWithEffects, $"seed {seed}: {count}");
    }

    // Of a car the long axis, of a panel any side, of a marker its upper edge.
    [Theory, Trait("Category", "Long")]
    [InlineData(2, -90)]
    [InlineData(3, -50)]
    public void Survey_TargetsWithADirectionOfOtherSeeds_TheirBearingsAreTrueWithinTheirErrors(
        int seed, double pitchDegrees)
        => Survey_TargetsWithADirection_TheirBearingsAreTrueWithinTheirErrors(seed, pitchDegrees);

    [Theory]
    [InlineData(1, -90)]
    public void Survey_TargetsWithADirection_TheirBearingsAreTrueWithinTheirErrors(int seed, double pitchDegrees)
    {
        Survey survey = Fly(
            (ulong)seed, 20, pitchDegrees: pitchDegrees, kinds:
            [
                SimulatedTargetKind.Car, SimulatedTargetKind.TwoColouredPanel, SimulatedTargetKind.ArUcoMarker,
                SimulatedTargetKind.WhitePanel, SimulatedTargetKind.AprilTagMarker,
            ]);
        foreach (IGrouping<string, SimulatedTarget> kind in survey.Things.Where(t => t.Declared is not null)
            .GroupBy(t => t.Name.Substring(0, t.Name.IndexOf(' '))))
        {
            TargetReport[] reports = [.. survey.Sink.Reports.Where(r => kind.Any(t => t.Class == r.Class))];
            TargetBearing[] bearings = [.. reports.Where(r => r.Bearing is not null).Select(r => r.Bearing!.Value)];
            double[] sigmas = [.. reports.Where(r => r.Bearing is not null).Select(r => Sigmas(survey, r))];
            string text = $"seed {seed}, {pitchDegrees}°, {kind.Key}: {sigmas.Length} of {reports.Length} reports, NEES "
                + $"{sigmas.Average(s => s * s):F2}, {sigmas.Max():F1} sigma of {bearings.Average(b => b.Sigma.Degrees):F1}°";
            output.WriteLine(text);
            Assert.True(2 * sigmas.Length >= reports.Length && sigmas.Max() < 3, text);
        }
    }

    // Of the bearing in a report, by that of the nearest target of its class.
    private static double Sigmas(Survey survey, TargetReport report)
    {
        SimulatedTarget nearest = survey.Things.Where(t => t.Class == report.Class)
            .OrderBy(t => survey.ErrorOf(report, t)).First();
        TargetBearing bearing = report.Bearing!.Value;
        return bearing.DistanceTo(nearest.Heading) / bearing.Sigma;
    }

    private static Survey Fly(
        ulong seed, double height, Action<SimulatedCameraOptions>? change = null, double pitchDegrees = -90,
        params SimulatedTargetKind[] kinds)
    {
        var camera = new SimulatedCameraOptions();
        change?.Invoke(camera);
        var truth = new TruthHistory(400);
        var frame = new WorldFrame(GeodeticPosition.FromRadians(0.8395, 0.1486, 445));
        IReadOnlyList<SimulatedTarget> things = TargetField.Place(
            seed, Scene.Corners((-5, -10), (-5, 65), (75, 65), (75, -10)), 10, 10, kinds, 0);
        var source = new SimulatedCamera(camera, truth, things, seed);
        var manager = new ImageProcessingManager(
            new ImageProcessingOptions
            {
                TargetClasses =
                [
                    .. TargetClass.Defaults,
                    .. things.Select(t => t.Declared).OfType<TargetClass>().GroupBy(c => c.Name).Select(c => c.First()),
                ],
                Camera = camera.Camera,
                Mount = new CameraMount
                {
                    GimbalLeverArmMetres = new BodyVector(
                        camera.LeverArmForwardMetres, camera.LeverArmRightMetres, camera.LeverArmDownMetres),
                },
            },
            source);
        var sink = new ReportSink();
        var order = new ImagingCommand
        {
            Mode = ImagingMode.Search,
            CameraPitch = Angle.FromDegrees(pitchDegrees),
            GroundAltitudeAmslMetres = frame.Origin.AltitudeAmslMetres,
        };
        var flight = new SurveyFlight(truth, frame, height, order);
        var reactor = new RabitReactor(new VirtualTime((long)seed))
        {
            flight,
            manager,
            sink
        };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(45));
        reactor.Stop();
        Assert.Equal(0, reactor.Finish().ExitCode);
        Assert.Empty(source.BufferHolders());
        Assert.InRange(sink.Observations.Count, 85, 90);
        return new Survey(frame, things, sink, flight);
    }

    private sealed class Survey(
        WorldFrame frame, IReadOnlyList<SimulatedTarget> things, ReportSink sink, SurveyFlight flight)
    {
        public IReadOnlyList<SimulatedTarget> Things { get; } = things;

        public ReportSink Sink { get; } = sink;

        /// <summary>What of the targets was seen, in the pictures that show them whole and so large.</summary>
        public SurveyCount Count(double margin, double minPixels)
        {
            var count = new SurveyCount();
            foreach (CameraObservation observation in Sink.Observations)
            {
                foreach (SimulatedTarget target in Things.Where(
                    t => !t.IsDistractor && IsInside(observation, t, margin) && PixelsOf(observation, t) >= minPixels))
                {
                    count.Expected++;
                    count.Found += Sink.Reports.Any(r => r.PictureNumber == observation.Number
                        && r.Class == target.Class && ErrorOf(r, target) < 1.5) ? 1 : 0;
                }
            }

            count.Wrong = Sink.Reports.Count(
                r => !Things.Any(t => !t.IsDistractor && t.Class == r.Class && ErrorOf(r, t) < 2.5));
            return count;
        }

        // The shorter side of the picture of a panel of 1 m, from the middle of the camera's track.
        private double PixelsOf(CameraObservation observation, SimulatedTarget target)
        {
            NedPosition camera = flight.PoseAt(observation.Time).Position;
            double height = -camera.Down;
            double range2 = Math.Pow(target.Position.North - camera.North, 2)
                + Math.Pow(target.Position.East - camera.East, 2) + (height * height);
            return 530 * height / range2;
        }

        public double ErrorOf(TargetReport report, SimulatedTarget target)
        {
            NedVector at = frame.ToWorld(report.Position);
            return Math.Sqrt(
                Math.Pow(at.North - target.Position.North, 2) + Math.Pow(at.East - target.Position.East, 2));
        }

        public string Describe(TargetReport report)
        {
            SimulatedTarget nearest = Things.OrderBy(t => ErrorOf(report, t)).First();
            return $"{report.Class} in observation {report.PictureNumber}, {report.SizeMetres:F2} m, score "
                + $"{report.Score:F2}, nearest is {nearest.Name} at {ErrorOf(report, nearest):F1} m";
        }

        public bool IsInside(CameraObservation observation, SimulatedTarget target, double margin)
        {
            NedVector[] corners = [frame.ToWorld(observation.TopLeft), frame.ToWorld(observation.TopRight),
                frame.ToWorld(observation.BottomRight), frame.ToWorld(observation.BottomLeft)];
            for (int i = 0; i < 4; i++)
            {
                (NedVector a, NedVector b) = (corners[i], corners[(i + 1) % 4]);
                (double north, double east) = (b.North - a.North, b.East - a.East);
                double length = Math.Sqrt((north * north) + (east * east));

                // Clockwise seen from above: the inside is to the right.
                double inside =
                    ((north * (target.Position.East - a.East)) - (east * (target.Position.North - a.North))) / length;
                if (inside < margin)
                    return false;
            }

            return true;
        }
    }

    private sealed class SurveyCount
    {
        public int Expected { get; set; }

        public int Found { get; set; }

        public int Wrong { get; set; }

        public override string ToString() => $"{Found} of {Expected} found, {Wrong} wrong";
    }
}
