using System;
using System.IO;
using System.Linq;
using Rabit.Geodesy.Tests;
using Rabit.Uav.Tests.ImageProcessing.Quality;
using VisionBench;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// The detector of shapes on generated pictures with truth: twelve of them, which are part of the repository, and the
/// whole sets where they are.
/// </summary>
public class ShapeTargetDetectorSetTests
{
    [Fact]
    public void Detect_TwelveStills_FindsWhatItShould()
    {
        SetScore score = ScoreOf(Path.Combine(TestData.Folder, "detection", "stills"));
        Assert.Equal(12, score.Frames);
        Check(score, leastRecall: 0.96, leastOfSmall: 0.8, mostFalseAlarms: 0.35, mostRms: 0.2);
        Assert.InRange(score.ClippedErrors.Mean, 1.5, 2.8);   // nine of them: too few for how many lie inside
    }

    [PictureSetTheory]
    [InlineData("stills_640", 0.97, 0.9, 0.34, 0.2)]
    [InlineData("stills_1640", 0.99, 0, 0.1, 0.2)]   // which has none below 6 px
    [InlineData("sequence_01", 0.99, 0.6, 0.075, 0.12)]
    public void Detect_ASet_FindsWhatItShould(
        string set, double leastRecall, double leastOfSmall, double mostFalseAlarms, double mostRms)
    {
        SetScore score = ScoreOf(Vectors.FolderOf(Path.Combine("imagery", set))!);
        Check(score, leastRecall, leastOfSmall, mostFalseAlarms, mostRms);
        if (score.ClippedErrors.Count > 0)
            CheckConsistency(score.ClippedErrors);
    }

    // On the odd ones the parameters were tuned.
    [PictureSetTheory]
    [InlineData("stills_640", 0.9, 0.35)]
    [InlineData("stills_1640", 0, 0.8)]
    [InlineData("sequence_01", 0.6, 0.08)]
    public void Detect_EvenPicturesOfASet_FindsWhatItShould(string set, double leastOfSmall, double mostFalseAlarms)
    {
        SetScore score = ScoreOf(Vectors.FolderOf(Path.Combine("imagery", set))!, "--part", "even");
        (int found, int of) = score.BySize(6, double.PositiveInfinity);
        Assert.True(found >= 0.96 * of, $"{found} of {of} found");
        (found, of) = score.BySize(4, 6);
        Assert.True(found >= leastOfSmall * of, $"{found} of {of} small ones found");
        Assert.InRange(score.FalseAlarmsPerFrame, 0, mostFalseAlarms);
        Assert.InRange(score.ClearPanelRms, 0, 0.3);
    }

    private static void CheckConsistency((double Mean, double Inside, int Count) errors)
    {
        Assert.InRange(errors.Mean, 1.5, 2.8);
        Assert.InRange(errors.Inside, 0.92, 0.98);
    }

    private static void Check(
        SetScore score, double leastRecall, double leastOfSmall, double mostFalseAlarms, double mostRms)
    {
        (int found, int of) = score.BySize(6, double.PositiveInfinity);
        Assert.True(found >= leastRecall * of, $"{found} of {of} found");
        Assert.InRange(score.FalseAlarmsPerFrame, 0, mostFalseAlarms);
        Assert.InRange(score.ClearPanelRms, 0, mostRms);
        Assert.Equal(0, score.Duplicates);
        CheckConsistency(score.ClearErrors);
        (found, of) = score.BySize(4, 6);
        Assert.True(found >= leastOfSmall * of, $"{found} of {of} small ones found");
    }

    private static SetScore ScoreOf(string folder, params string[] arguments)
    {
        PictureSet set = PictureSet.Load(folder);
        BenchOptions options = BenchOptions.Parse([folder, .. arguments]);
        Bench bench = options.CreateBench(BenchClasses.All);
        return new SetScore(
            set.Name, bench.Run(set, (_, _) => { }).Where(s => options.Includes(s.Frame.Index)).ToList());
    }
}
