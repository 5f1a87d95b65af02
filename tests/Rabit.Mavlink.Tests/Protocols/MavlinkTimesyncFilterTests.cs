using System;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// The offset and the drift of a clock behind a link with unequal delays, and what the filter says of its errors.
/// </summary>
public sealed class MavlinkTimesyncFilterTests(ITestOutputHelper output)
{
    private const double Drift = 20e-6;

    // Two standard deviations, and with messages also the worst of all seeds. How long that takes is information, not
    // method.
    [Theory]
    [InlineData(256, 0, Drift)]
    [InlineData(256, 25, -50e-6)]
    public void Drift_GammaDelays_IsKnownToTwoPpm(int seconds, int messagesPerSecond, double drift)
    {
        (double squares, double worst, double normalised, double offset) = (0, 0, 0, 0);
        const int Seeds = 50;
        for (ulong seed = 1; seed <= Seeds; seed++)
        {
            var link = new TwoClocks(seed) { Drift = drift, MessagesPerSecond = messagesPerSecond };
            link.Run(seconds);
            double error = Math.Abs(link.Filter.Drift - drift);
            (squares, worst) = (squares + (error * error / Seeds), Math.Max(worst, error));
            normalised += Math.Pow(error / link.Filter.DriftError, 2) / Seeds;
            offset = Math.Max(offset, Math.Abs(link.OffsetError()));
        }

        output.WriteLine(FormattableString.Invariant(
            $"seeds 1 to {Seeds}, {seconds} s, {messagesPerSecond} messages a second: drift {Math.Sqrt(squares) * 1e6:0.00} ppm rms, {worst * 1e6:0.00} at worst, normalised square {normalised:0.00}; offset {offset * 1e3:0.000} ms at worst"));
        Assert.True(Math.Sqrt(squares) < 1e-6, $"{Math.Sqrt(squares)}");
        Assert.True(worst < 2e-6 || messagesPerSecond == 0, $"{worst}");
        Assert.InRange(normalised, 0.2, 1.4);
        Assert.True(offset < 0.5e-3, $"{offset}");
    }

    // The mean of 200 normalised squares is in 0.8 to 1.2 in 95 % where the statement is exact; it may be more cautious
    // than that.
    [Theory]
    [InlineData(10)]
    [InlineData(30)]
    [InlineData(120)]
    public void OffsetError_AnyTime_IsStatedHonestly(int seconds)
    {
        (double squares, double normalised, double beyond) = (0, 0, 0);
        for (ulong seed = 1; seed <= 200; seed++)
        {
            var link = new TwoClocks(seed) { Drift = Drift };
            link.Run(seconds);
            double error = link.OffsetError();
            double inSigmas = Math.Abs(error) / link.StatedOffsetError();
            squares += error * error / 200;
            normalised += inSigmas * inSigmas / 200;
            beyond += inSigmas > 2 ? 1 / 200.0 : 0;
        }

        output.WriteLine(FormattableString.Invariant(
            $"seeds 1 to 200, {seconds} s: offset {Math.Sqrt(squares) * 1e3:0.000} ms rms, normalised square {normalised:0.00}, beyond two deviations {beyond:P1}"));
        Assert.InRange(normalised, 0.3, 1.2);
        Assert.True(beyond <= 0.08, $"{beyond}");
    }

    [Theory]
    [InlineData(0.05)]
    [InlineData(-0.3)]
    [InlineData(40)]
    public void Take_ClockSteps_RestartsAndForgetsTheMessages(double step)
    {
        var link = new TwoClocks(7) { Drift = Drift };
        link.Run(120);
        link.Step = step;
        link.Run(60);
        Assert.Equal(1, link.Filter.Jumps);
        Assert.True(Math.Abs(link.OffsetError()) < 0.7e-3, $"{link.OffsetError()}");
        Assert.Equal(Drift, link.Filter.Drift, 4 * link.Filter.DriftError);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(-0.05)]
    [InlineData(1e9)]
    public void AddRoundTrip_OneWrongAnswer_IsPutAsideAndDiscardsNothing(double wrongBy)
    {
        for (ulong seed = 1; seed <= 10; seed++)
        {
            var link = new TwoClocks(seed) { Drift = Drift };
            var right = new TwoClocks(seed) { Drift = Drift };
            link.Run(240);
            right.Run(240);
            link.NextAnswerWrongBy = wrongBy;
            for (int i = 0; i < 5; i++)
            {
                link.Run(1);
                right.Run(1);
                Assert.True(link.Filter.IsKnown(TimeSpan.FromSeconds(link.Seconds)));
                Assert.Equal(right.OffsetError(), link.OffsetError(), 0.2e-3);
            }

            Assert.Equal((1, 0), (link.Filter.Contradictions, link.Filter.Jumps));
        }
    }

    // Two wrong answers that do not agree with each other are two wrong answers.
    [Fact]
    public void AddRoundTrip_TwoWrongAnswersThatDisagree_DiscardNothing()
    {
        var link = new TwoClocks(3) { Drift = Drift };
        link.Run(120);
        foreach (double wrongBy in new[] { 1.0, -1.0, 2.0 })
        {
            link.NextAnswerWrongBy = wrongBy;
            link.Run(1);
        }

        Assert.Equal((3, 0), (link.Filter.Contradictions, link.Filter.Jumps));
        Assert.True(Math.Abs(link.OffsetError()) < 0.7e-3, $"{link.OffsetError()}");
    }

    [Fact]
    public void AddRoundTrip_NotANumber_IsRejectedAndCounted()
    {
        var link = new TwoClocks(3) { Drift = Drift };
        link.Run(30);
        double before = link.Filter.OffsetSecondsAt(link.Seconds);
        foreach (double theirs in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity })
        {
            Assert.False(link.Filter.AddRoundTrip(
                TimeSpan.FromSeconds(link.Seconds), TimeSpan.FromSeconds(link.Seconds + 0.01), theirs));
        }

        Assert.Equal(3, link.Filter.Rejected);
        Assert.Equal(before, link.Filter.OffsetSecondsAt(link.Seconds));
    }

    // The delays of these answers scatter by 4 ms, so that only the quick ones show such a step: two of those are
    // waited for.
    [Theory]
    [InlineData(3e-3, 30)]
    [InlineData(-3e-3, 30)]
    [InlineData(6e-3, 12)]
    [InlineData(-6e-3, 12)]
    [InlineData(12e-3, 6)]
    public void AddRoundTrip_SmallStep_IsNotTakenForDriftForLong(double step, int mean)
    {
        (double sum, int worst) = (0, 0);
        const int Seeds = 40;
        for (ulong seed = 1; seed <= Seeds; seed++)
        {
            var link = new TwoClocks(seed) { Drift = Drift };
            link.Run(240);
            link.Step = step;
            int wrongUntil = 0;
            for (int i = 1; i <= 90; i++)
            {
                link.Run(1);
                if (Math.Abs(link.OffsetError()) > 1e-3)
                    wrongUntil = i;
            }

            (sum, worst) = (sum + wrongUntil, Math.Max(worst, wrongUntil));
        }

        output.WriteLine(FormattableString.Invariant(
            $"seeds 1 to {Seeds}, {step * 1e3} ms: within 1 ms after {sum / Seeds:0.0} s, {worst} s at worst"));
        Assert.True(sum / Seeds < mean, $"{sum / Seeds}");
    }

    [Fact]
    public void AddRoundTrip_ScatteredDelays_AreNoContradictions()
    {
        long contradictions = 0;
        for (ulong seed = 1; seed <= 40; seed++)
        {
            var link = new TwoClocks(seed) { Drift = Drift };
            link.Run(600);
            contradictions += link.Filter.Contradictions;
            Assert.Equal(0, link.Filter.Jumps);
        }

        output.WriteLine($"{contradictions} contradictions");
        Assert.True(contradictions < 24, $"{contradictions} of 24000 answers");
    }

    // Other messages asked for, another radio rate: all messages come later or sooner from then on.
    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    [InlineData(3)]
    [InlineData(-3)]
    [InlineData(20)]
    [InlineData(-20)]
    public void AddOneWay_DelayOfAllMessagesChanges_MovesTheOffsetLittle(double milliseconds)
    {
        double worst = 0;
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var link = new TwoClocks(seed) { Drift = Drift, MessageDelay = 30e-3 };
            link.Run(60);
            link.MessageDelay += milliseconds * 1e-3;
            for (int i = 0; i < 60; i++)
            {
                link.Run(1);
                worst = Math.Max(worst, Math.Abs(link.OffsetError()));
            }
        }

        output.WriteLine(
            FormattableString.Invariant($"seeds 1 to 20, by {milliseconds} ms: {worst * 1e3:0.000} ms at worst"));
        Assert.True(worst < 2e-3, $"{worst}");
    }

    [Fact]
    public void AddOneWay_OfAnotherClockOrWithoutAnswers_IsNotTaken()
    {
        var filter = new MavlinkTimesyncFilter();
        filter.AddOneWay(TimeSpan.FromSeconds(1), 500);
        Assert.True(double.IsNaN(filter.DriftError));
        for (int i = 0; i < 30; i++)
        {
            filter.AddRoundTrip(TimeSpan.FromSeconds(i), TimeSpan.FromSeconds(i + 0.01), i + 100.005);
            filter.AddOneWay(TimeSpan.FromSeconds(i + 0.5), 7000 - i);
            filter.AddOneWay(TimeSpan.FromSeconds(i + 0.6), double.NaN);
        }

        Assert.Equal(0, filter.Drift, 1e-7);
        Assert.Equal(100, filter.OffsetSecondsAt(29), 1e-6);
    }

    [Fact]
    public void OffsetError_NoAnswersForLong_Grows()
    {
        var link = new TwoClocks(3) { Drift = Drift };
        link.Run(30);
        double now = link.StatedOffsetError();
        Assert.True(link.Filter.OffsetErrorSecondsAt(link.Seconds + 60) > 1.5 * now);
    }

    [Fact]
    public void AddRoundTripAndOneWay_Often_AllocateNothing()
    {
        var filter = new MavlinkTimesyncFilter();
        Assert.Equal(0, Allocated.By(() =>
        {
            for (int i = 0; i < 1000; i++)
            {
                filter.AddRoundTrip(TimeSpan.FromSeconds(i), TimeSpan.FromSeconds(i + 0.01), i + 0.005);
                filter.AddOneWay(TimeSpan.FromSeconds(i + 0.5), i + 0.48);
            }
        }));
    }
}
