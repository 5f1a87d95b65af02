using System;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>
/// Surveys that no parameter of a detector was chosen on: other seeds, and so other ground and places, and light that
/// no other test has. Do not tune on them: where something is to be improved, take other seeds.
/// </summary>
public sealed class SecondPictureSetTests(ITestOutputHelper output)
{
    // So that no car is cut by the border.
    private const double EdgeMetres = 3.5;

    // 0.05 below the least of the generated sets, 0.98, for all of it. What one light may have less was measured.
    private const double MinRecall = 0.93;
    private const double MinRecallInOneLight = 0.9;
    private const double MaxWrongPerPicture = 0.03;

    private static readonly (ulong FirstSeed, string Light)[] Lights =
        [(601, "plain"), (606, "warm"), (611, "cold"), (616, "bright"), (621, "clouds")];

    private static readonly SimulatedTargetKind[] Kinds =
    [
        SimulatedTargetKind.ColouredPanel, SimulatedTargetKind.WhitePanel, SimulatedTargetKind.TwoColouredPanel,
        SimulatedTargetKind.Person, SimulatedTargetKind.Car, SimulatedTargetKind.BlackPanel,
    ];

    [Fact, Trait("Category", "Long")]
    public void Survey_SeedsAndLightThatNothingWasChosenOn_FindsMostTargets()
    {
        var all = new SurveyCount();
        int pictures = 0;
        foreach ((ulong firstSeed, string light) in Lights)
        {
            SurveyCount count = FlyFive(firstSeed, light, ref pictures);
            Assert.True(count.Expected > 200, $"{count.Expected} targets in view are too few to decide");
            Assert.True(count.Found >= MinRecallInOneLight * count.Expected, $"{light}: {count}");
            all.Add(count);
        }

        output.WriteLine($"all: {all} in {pictures} pictures");
        Assert.True(all.Found >= MinRecall * all.Expected, all.ToString());
        Assert.True(all.Wrong <= MaxWrongPerPicture * pictures, $"{all} in {pictures} pictures");
    }

    private SurveyCount FlyFive(ulong firstSeed, string light, ref int pictures)
    {
        var sum = new SurveyCount();
        for (ulong number = 0; number < 5; number++)
        {
            double heightMetres = 18 + (2 * number);   // from higher a person is too small
            Survey survey = Survey.Fly(
                firstSeed + number, heightMetres, camera => camera.Effects = LightOf(light), targets: 12,
                partlyHidden: 1, kinds: Kinds);
            SurveyCount count = survey.Count(EdgeMetres, minPixels: 0);
            output.WriteLine(FormattableString.Invariant(
                $"seed {firstSeed + number}, {light}, {heightMetres} m: {count}"));
            foreach (string line in survey.DescribeFaults(EdgeMetres))
                output.WriteLine("  " + line);
            sum.Add(count);
            pictures += survey.Sink.Observations.Count;
        }

        output.WriteLine($"{light}: {sum}");
        return sum;
    }

    private static SimulatedPictureEffects LightOf(string light) => light switch
    {
        "plain" => new() { JpegQuality = 85 },
        "warm" => new() { RedGain = 1.06, BlueGain = 0.94, JpegQuality = 85 },
        "cold" => new() { RedGain = 0.95, BlueGain = 1.06, JpegQuality = 85 },
        "bright" => new() { ExposureGain = 1.25, Vignetting = 0.1, JpegQuality = 85 },
        "clouds" => new() { Shade = 0.4, Vignetting = 0.2, JpegQuality = 85 },
        _ => throw new ArgumentException($"There is no light \"{light}\".", nameof(light)),
    };
}
