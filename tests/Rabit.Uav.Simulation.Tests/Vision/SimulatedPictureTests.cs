using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
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
    private const double MinRecallFromHigh = 0.99;
    private const double MaxWrongFromHigh = 0.04;

    [Theory]
    [InlineData(1, 40)]
    [InlineData(2, 40)]
    [InlineData(3, 25)]
    [InlineData(4, 60)]
    public void Survey_TruePoses_EveryTargetInEveryPictureIsReportedWhereItIs(int seed, double height)
    {
        Survey survey = Survey.Fly((ulong)seed, height);
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

    /// <summary>
    /// A brown-red crate of the size of a panel, 7 to 10 pixels: where three vehicles search above each other the
    /// highest one took such for red panels. Other seeds than those that the limits of dull colours were chosen on.
    /// </summary>
    [Theory, Trait("Category", "Long")]
    [InlineData(55)]
    [InlineData(65)]
    [InlineData(74)]
    public void Survey_FromHigh_CratesAreSeldomPanels(double height)
    {
        var all = new SurveyCount();
        int pictures = 0;
        for (ulong seed = 911; seed <= 916; seed++)
        {
            Survey survey = Survey.Fly(seed, height);
            all.Add(survey.Count(EdgeMetres, minPixels: 0));
            pictures += survey.Sink.Observations.Count;
        }

        output.WriteLine($"{height} m: {all} in {pictures} pictures");
        Assert.True(all.Found >= MinRecallFromHigh * all.Expected, all.ToString());
        Assert.True(all.Wrong <= MaxWrongFromHigh * pictures, $"{all} in {pictures} pictures");
    }

    // At 30 m, with a camera that is exposed for 6 ms: the recall of the default detector with all effects.
    [Theory, Trait("Category", "Long")]
    [InlineData(1)]
    [InlineData(2)]
    public void Survey_ModerateEffects_KeepsItsRecall(int seed)
    {
        Survey survey = Survey.Fly((ulong)seed, 30, c =>
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
        Survey survey = Survey.Fly((ulong)seed, 25, _ => { }, pitchDegrees: -45);

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
        Survey survey = Survey.Fly(
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
}
