using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>Tracks that were started less those that are no more are those that there are.</summary>
public sealed class TrackCountTests(ITestOutputHelper output)
{
    private static readonly TargetClassName Person = new("person");

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Counters_OfAnythingThatComes_AddUpToTheTracks(int seed)
    {
        var random = new SeededNumbers(seed);
        using FusionRig rig = Rig();
        for (int i = 0; i < 300; i++)
        {
            if (random.Uniform(0, 1) < 0.2)
                rig.Push(Known(random, rig.Now, i));
            if (random.Uniform(0, 1) < 0.1)
                rig.Push(Other(random, rig.Now, i));

            // Five who walk, of whom none is seen in parts of the way, one panel that stands, and reports of nothing.
            var reports = new List<TargetReport>();
            for (int k = 0; k < 5; k++)
            {
                if ((i + (12 * k)) % 60 > 25 && random.Uniform(0, 1) < 0.9)
                    reports.Add(FusionRig.Report(0.5 * (i % 100), (20 * k) + (0.5 * random.Gauss()), Person));
            }

            if (random.Uniform(0, 1) < 0.3)
                reports.Add(FusionRig.Report(random.Uniform(-60, 60), random.Uniform(-60, 60), Person));
            if (random.Uniform(0, 1) < 0.3)
                reports.Add(FusionRig.Report(random.Uniform(-3, 3), random.Uniform(-3, 3)));
            rig.Observe(0, 0, 120, 120, [.. reports]);
            AssertThatTheyAddUp(rig);
        }

        rig.Run(60);
        AssertThatTheyAddUp(rig);
        SensorFusionCounters c = rig.Counters;
        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: {c.TracksStarted} + {c.TracksStartedByEstimates} - {c.TracksDropped} - {c.TracksMerged}"));
        Assert.All(
            [c.TracksStarted, c.TracksStartedByEstimates, c.TracksDropped, c.TracksMerged],
            count => Assert.InRange(count, 1, 1000));
    }

    // The first report was wrong: what was started with it is dropped, and counted.
    [Fact]
    public void Counters_FrameThatMoves_CountWhatItDrops()
    {
        using FusionRig rig = Rig();
        rig.Observe(50_000, 0, FusionRig.Report(50_000, 0, Person), FusionRig.Report(50_010, 0));
        Assert.Equal(2, rig.Tracks.Count);
        rig.Observe(0, 0, FusionRig.Report(0, 0, Person));
        Assert.Equal(2, rig.Counters.TracksDropped);
        AssertThatTheyAddUp(rig);
    }

    // No report comes with it.
    [Fact]
    public void Counters_TrackOfOthersThatIsTooOld_CountItAsDropped()
    {
        using FusionRig rig = Rig();
        rig.Run(1);
        rig.Push(Known(new SeededNumbers(1), rig.Now, 0));
        rig.Run(60);
        Assert.Equal(1, rig.Counters.TracksDropped);
        AssertThatTheyAddUp(rig);
    }

    private static void AssertThatTheyAddUp(FusionRig rig)
    {
        SensorFusionCounters c = rig.Counters;
        Assert.Equal(
            rig.Tracks.Count, c.TracksStarted + c.TracksStartedByEstimates - c.TracksDropped - c.TracksMerged);
    }

    private static FusionRig Rig() => new(o =>
    {
        o.TargetMotions = o.TargetMotions.Add(Person, TargetMotion.Walking);
        o.SharesTracks = true;
    });

    private static TrackEstimate Known(SeededNumbers random, TimeSpan now, int number)
    {
        double age = random.Uniform(0, Math.Min(20, now.TotalSeconds));
        return new()
        {
            SourceSystemId = 2,
            TrackId = 4,
            PictureNumber = number,
            Time = now - TimeSpan.FromMilliseconds(Math.Floor(1000 * age)),
            Position = PlaceAt(random.Uniform(-100, 100), random.Uniform(-100, 100)),
            VelocityNed = new NedVector(1, 0, 0),
            Covariance = new HorizontalCovariance(1, 0, 1),
            VelocityCovariance = new HorizontalCovariance(0.01, 0, 0.01),
            Class = Person,
        };
    }

    private static TargetReport Other(SeededNumbers random, TimeSpan now, int number)
    {
        TargetReport report = FusionRig.Report(random.Uniform(-60, 60), random.Uniform(-60, 60), Person);
        return report with { SourceSystemId = 2, PictureNumber = number, Time = now };
    }

    private static GeodeticPosition PlaceAt(double north, double east)
        => LocalNedFrame.IgnoringGeoid(FusionRig.Origin).ToGeodetic(new NedPosition(north, east, 0));
}
