using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>States of other vehicles and reports that are older than what is known, or than we are.</summary>
public sealed class TrackEstimateTimeTests
{
    private static readonly TargetClassName Person = new("person");

    [Fact]
    public void Estimate_FromBeforeWeWereSwitchedOn_IsUsed()
    {
        using FusionRig late = Rig();
        late.Run(1);
        late.Push(FusionRig.Known(2, TimeSpan.FromSeconds(-12), 0, new HorizontalCovariance(1, 0, 1)));
        late.Run(1.5);
        Assert.Equal((1, 0), (late.Counters.EstimatesUsed, late.Counters.EstimatesRefused));
        Assert.Equal(TimeSpan.FromSeconds(-12), late.Only.Time);
        late.Run(30);
        Assert.Empty(late.Tracks);
    }

    // It is in the state already, or may be: it starts no track beside it. Another target has its own.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Report_OlderThanAState_IsLateAndStartsNoTrack(bool isKnownBefore)
    {
        using FusionRig rig = Rig();
        if (isKnownBefore)
            Walk(rig);
        rig.Run(11);
        double now = rig.Now.TotalSeconds;
        rig.Push(FusionRig.Known(2, rig.Now, now, new HorizontalCovariance(1, 0, 1)));
        rig.Run(1.5);
        int tracks = rig.Tracks.Count;
        SensorFusionCounters before = rig.Counters;
        for (int i = 0; i < 5; i++)
        {
            TargetReport old = FusionRig.Report(now - 4 + i + 1.5, 0, Person);
            rig.Push(old with { SourceSystemId = 3, PictureNumber = i, Time = TimeSpan.FromSeconds(now - 5 + i) });
            rig.Run(0.5);
        }

        Assert.Equal(tracks, rig.Tracks.Count);
        Assert.Equal(before.ReportsLate + 5, rig.Counters.ReportsLate);
        Assert.Contains(new RefusedReports(3, ReportFault.TooOld, 5), rig.Counters.Refused);

        TargetReport other = FusionRig.Report(now + 200, 0, Person);
        rig.Push(other with { SourceSystemId = 3, PictureNumber = 9, Time = TimeSpan.FromSeconds(now - 1) });
        rig.Run(0.5);
        Assert.Equal(tracks + 1, rig.Tracks.Count);
    }

    private static FusionRig Rig() => new(o =>
    {
        o.TargetMotions = o.TargetMotions.Add(Person, TargetMotion.Walking);
        o.SharesTracks = true;
    });

    private static void Walk(FusionRig rig)
    {
        for (int i = 0; i < 10; i++)
            rig.Observe(0.5 * i, 0, FusionRig.Report(0.5 * i, 0, Person));
    }
}
