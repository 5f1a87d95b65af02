using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

public class AdviceLatchTests
{
    private static readonly HealthAdvice[] All =
        [HealthAdvice.None, HealthAdvice.Hold, HealthAdvice.ReturnToLaunch, HealthAdvice.Land];

    [Fact]
    public void Advice_SeveralAtOnce_IsTheMoreSevereInWhateverOrder()
    {
        foreach (HealthAdvice a in All)
        {
            foreach (HealthAdvice b in All)
            {
                var latch = new AdviceLatch();
                latch.Update([Finding(a, 1), Finding(b, 2)], isFlying: true);
                Assert.Equal(a > b ? a : b, latch.Advice);
                Assert.Equal(latch.Advice == HealthAdvice.None, latch.Text is null);
            }
        }
    }

    [Fact]
    public void Hold_ReasonEnds_IsWithdrawn()
    {
        var latch = new AdviceLatch();
        latch.Update([Finding(HealthAdvice.Hold, 7)], isFlying: true);
        Assert.Equal((HealthAdvice.Hold, "wind too strong (7 m/s)"), (latch.Advice, latch.Text));
        latch.Update([], isFlying: true);
        Assert.Equal((HealthAdvice.None, null), (latch.Advice, latch.Text));
    }

    [Fact]
    public void Hold_AfterOneToReturn_ChangesNothing()
    {
        var latch = new AdviceLatch();
        latch.Update([Finding(HealthAdvice.ReturnToLaunch, 1)], isFlying: true);
        latch.Update([Finding(HealthAdvice.Hold, 2)], isFlying: true);
        Assert.Equal((HealthAdvice.ReturnToLaunch, "wind too strong (1 m/s)"), (latch.Advice, latch.Text));
        latch.Update([], isFlying: true);
        Assert.Equal(HealthAdvice.ReturnToLaunch, latch.Advice);
    }

    [Fact]
    public void Hold_NoMissionInFlight_IsNotGiven()
    {
        var latch = new AdviceLatch();
        latch.Update([Finding(HealthAdvice.Hold, 1)], isFlying: false);
        Assert.Equal(HealthAdvice.None, latch.Advice);
    }

    [Fact]
    public void Hold_UnchangedReason_MakesItsTextOnce()
    {
        var latch = new AdviceLatch();
        latch.Update([Finding(HealthAdvice.Hold, 1)], isFlying: true);
        string? text = latch.Text;
        latch.Update([Finding(HealthAdvice.Hold, 1)], isFlying: true);
        Assert.Same(text, latch.Text);
        latch.Update([Finding(HealthAdvice.Hold, 2)], isFlying: true);
        Assert.Equal("wind too strong (2 m/s)", latch.Text);
    }

    private static HealthFinding Finding(HealthAdvice advice, long figure)
        => new(HealthReasons.WindHigh, HealthLevel.Warning, null, figure, advice);
}
