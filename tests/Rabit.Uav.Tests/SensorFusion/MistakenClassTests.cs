using System.Linq;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Tests.SensorFusion.FusionRig;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>
/// A target that is taken for one of another class in a few pictures is one target; two that may be two stay two.
/// </summary>
public sealed class MistakenClassTests
{
    // Half of a panel of two colours may look like a jacket in a few pictures.
    [Fact]
    public void Tracks_OneWasTakenForAnotherClassNowAndThen_TheOtherIsDropped()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 12; i++)
            rig.Observe(0, 0, Report(0, 0));
        foreach (bool isMistaken in new[] { true, true, true, false, true })
            rig.Observe(0, 0, isMistaken ? Report(0.5, 0, DefaultTargetClasses.Blue) : Report(0, 0));
        Assert.Equal([TrackState.Confirmed, TrackState.Confirmed], rig.Tracks.Select(t => t.State));
        rig.Observe(0, 0, Report(0, 0));
        Assert.Equal(DefaultTargetClasses.Red, rig.Only.Class);
        Assert.Equal(14, rig.Only.Reports);
        Assert.Equal(1, rig.Counters.TracksMerged);
    }

    // A person may stand beside a panel, or lie on it.
    [Theory]
    [InlineData("seen together once")]
    [InlineData("at the border of the picture")]
    [InlineData("the first not seen again")]
    [InlineData("seen nearly as often")]
    [InlineData("another vehicle sees it")]
    [InlineData("another vehicle sees it too")]
    [InlineData("two metres apart")]
    [InlineData("its marker was read")]
    [InlineData("the operator confirmed it")]
    public void Tracks_TwoClassesThatMayBeTwoTargets_BothStay(string what)
    {
        using var rig = new FusionRig();
        TargetReport other = what == "two metres apart"
            ? Report(2, 0, DefaultTargetClasses.Blue, sigma: 2)
            : Report(0.5, 0, DefaultTargetClasses.Blue);
        other.MarkerId = what == "its marker was read" ? 7 : null;
        for (int i = 0; i < (what == "seen nearly as often" ? 3 : 15); i++)
            rig.Observe(0, 0, Report(0, 0));
        if (what == "seen together once")
            rig.Observe(0, 0, Report(0, 0), other);
        if (what == "another vehicle sees it too")
            rig.Push(other with { SourceSystemId = 2, PictureNumber = 9, Time = rig.Now });
        for (int i = 0; i < 4; i++)
        {
            if (what == "another vehicle sees it")
                rig.Push(other with { SourceSystemId = 2, PictureNumber = i, Time = rig.Now });
            else
                rig.Observe(0, 0, other);
            if (i == 0 && what == "the operator confirmed it")
                rig.Decide(rig.Tracks.Single(t => t.Class == other.Class).Id, TargetDecision.Confirmed);
            if (what is not ("the first not seen again" or "at the border of the picture"))
                rig.Observe(0, 0, Report(0, 0));
        }

        for (int i = 0; what == "at the border of the picture" && i < 4; i++)
            rig.Observe(0, 0, Report(0, 0));
        Assert.Equal(2, rig.Tracks.Count);
        Assert.Equal(0, rig.Counters.TracksMerged);
    }
}
