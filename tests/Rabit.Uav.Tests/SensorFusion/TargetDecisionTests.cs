using System.Linq;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Tests.SensorFusion.FusionRig;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>The operator's decision on a track is kept, whatever the camera reports.</summary>
public class TargetDecisionTests
{
    [Fact]
    public void Decide_Rejected_IsNotConfirmedByMoreReports()
    {
        using var rig = new FusionRig();
        Report(rig, 3);
        Assert.Equal(1, rig.List.ConfirmedCount);
        rig.Decide(1, TargetDecision.Rejected);
        Assert.Equal((TrackState.Rejected, TargetDecision.Rejected), (rig.Only.State, rig.Only.Decision));
        int sent = rig.SentReports.Count;
        Report(rig, 20);
        Assert.Equal((TrackState.Rejected, 1), (rig.Only.State, rig.Only.Id));
        Assert.Equal((0, 1), (rig.List.ConfirmedCount, rig.List.RejectedCount));
        Assert.Equal(sent, rig.SentReports.Count);
    }

    [Fact]
    public void Decide_Confirmed_IsNeverLost()
    {
        using var rig = new FusionRig();
        Report(rig, 1);
        Assert.Equal(TrackState.Tentative, rig.Only.State);
        rig.Decide(1, TargetDecision.Confirmed);
        for (int i = 0; i < 40; i++)
            rig.Observe(0, 0);
        Assert.Equal((TrackState.Confirmed, TargetDecision.Confirmed), (rig.Only.State, rig.Only.Decision));
        Assert.True(rig.Only.Misses >= 40);
    }

    [Fact]
    public void Decide_Again_TheNewestCounts()
    {
        using var rig = new FusionRig();
        Report(rig, 3);
        rig.Decide(1, TargetDecision.Rejected);
        rig.Decide(1, TargetDecision.Confirmed);
        Assert.Equal(TrackState.Confirmed, rig.Only.State);
    }

    [Fact]
    public void Decide_NoSuchTrack_ChangesNothing()
    {
        using var rig = new FusionRig();
        Report(rig, 3);
        int posts = rig.Posts;
        rig.Decide(7, TargetDecision.Rejected);
        rig.Decide(1, TargetDecision.None);
        Assert.Equal((TrackState.Confirmed, posts), (rig.Only.State, rig.Posts));
    }

    // Two tracks that turn out to be one target: the decision on either stays.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Decide_OneOfTwoTracksThatAreMerged_IsKept(int judged)
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 4; i++)
        {
            rig.Observe(0, 0, FusionRig.Report(3, 4, sigma: 0.2, common: 0.1));
            rig.Observe(0, 0, FusionRig.Report(5.5, 4, sigma: 0.2, common: 0.1));
        }

        Assert.Equal(2, rig.Tracks.Count);
        rig.Decide(judged, TargetDecision.Rejected);
        for (int i = 0; i < 60 && rig.Tracks.Count > 1; i++)
            rig.Observe(0, 0, FusionRig.Report(4.25, 4, sigma: 1, common: 1.5));
        Assert.Equal(TrackState.Rejected, rig.Tracks.Single().State);
    }

    private static void Report(FusionRig rig, int times)
    {
        for (int i = 0; i < times; i++)
            rig.Observe(0, 0, FusionRig.Report(3, 4));
    }
}
