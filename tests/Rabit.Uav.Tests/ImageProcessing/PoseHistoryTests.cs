using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class PoseHistoryTests
{
    private readonly PoseHistory _history = new(TimeSpan.FromSeconds(1));

    [Fact]
    public void Find_OutsideTheSamples_NeverExtrapolates()
    {
        Assert.Equal(PoseLookup.NotYet, _history.Find(Seconds(1), out _));
        AddBoth(1);
        AddBoth(1.2);
        Assert.Equal(PoseLookup.TooOld, _history.Find(Seconds(0.9999), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.2), out _));
        Assert.Equal(PoseLookup.NotYet, _history.Find(Seconds(1.2001), out _));
    }

    [Fact]
    public void Extrapolate_BeyondTheNewest_GoesOnAtTheSameRatesAndSaysHowFar()
    {
        _history.Add(
            new PoseSample
            {
                Kind = PoseSampleKind.Position,
                Time = Seconds(1),
                Position = Place(),
                VelocityNed = new NedVector(10, 0, -2)
            });
        _history.Add(
            new PoseSample
            {
                Kind = PoseSampleKind.Attitude,
                Time = Seconds(1.02),
                Rates = BodyRates.FromRadiansPerSecond(0, 0, 0.5)
            });
        Assert.Equal(PoseLookup.NotYet, _history.Extrapolate(Seconds(1.2), TimeSpan.FromMilliseconds(199), out _));
        Assert.Equal(PoseLookup.TooOld, _history.Extrapolate(Seconds(0.9), TimeSpan.FromSeconds(1), out _));

        Assert.Equal(
            PoseLookup.Extrapolated, _history.Extrapolate(Seconds(1.2), TimeSpan.FromMilliseconds(200), out Pose pose));
        Assert.Equal(0.2, pose.ExtrapolatedSeconds, 1e-9);
        Assert.Equal(100.4, pose.Position.AltitudeAmslMetres, 1e-3);
        Assert.Equal(2, LocalNedFrame.IgnoringGeoid(Place()).ToNed(pose.Position).North, 1e-6);
        Assert.Equal(0.09, pose.Attitude.ToEuler().Yaw.Radians, 1e-9);
        Assert.Equal(Seconds(1.2), pose.Time);
    }

    [Fact]
    public void Extrapolate_NothingThereOrABracket_IsAsFind()
    {
        Assert.Equal(PoseLookup.NotYet, _history.Extrapolate(Seconds(1), TimeSpan.FromSeconds(1), out _));
        AddBoth(1);
        AddBoth(1.2);
        Assert.Equal(PoseLookup.Known, _history.Extrapolate(Seconds(1.1), TimeSpan.FromSeconds(1), out Pose pose));
        Assert.Equal(0, pose.ExtrapolatedSeconds);
    }

    [Fact]
    public void Find_OnlyOneKindReachesSoFar_WaitsForTheOther()
    {
        AddBoth(1);
        AddAttitude(2, default);
        Assert.Equal(PoseLookup.NotYet, _history.Find(Seconds(1.5), out _));
        AddPosition(1.6, Place(), default);
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.5), out _));
    }

    [Fact]
    public void Find_SamplesTooFarApart_IsAGapEvenWhereTheOtherKindMayStillCome()
    {
        AddBoth(1);
        AddAttitude(2.1, default);
        Assert.Equal(PoseLookup.Gap, _history.Find(Seconds(1.5), out _));
        AddPosition(2.1, Place(), default);
        Assert.Equal(PoseLookup.Gap, _history.Find(Seconds(1.5), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(2.1), out _));
    }

    [Fact]
    public void Find_SamplesThatCameOutOfOrder_AreInOrder()
    {
        foreach (double t in new[] { 1.0, 1.4, 1.1, 1.3, 1.2 })
        {
            AddPosition(t, Place(altitude: 100 * t), new NedVector(0, 0, -100));
            AddAttitude(t, EulerAngles.FromRadians(0, 0, t));
        }

        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.25), out Pose pose));
        Assert.Equal(125, pose.Position.AltitudeAmslMetres, 1e-6);
        Assert.Equal(1.25, pose.Attitude.ToEuler().Yaw.Radians, 1e-9);
        Assert.Equal(0, _history.Refused);
    }

    [Fact]
    public void Add_SameMomentOrNotANumber_IsRefusedAndCounted()
    {
        AddBoth(1);
        AddPosition(1, Place(altitude: 7), default);
        AddPosition(1.1, Place(altitude: double.NaN), default);
        AddPosition(1.1, GeodeticPosition.FromRadians(double.NaN, 0, 0), default);
        AddPosition(1.1, GeodeticPosition.FromRadians(2, 0, 0), default);
        AddAttitude(1.1, EulerAngles.FromRadians(0, double.NaN, 0));
        AddAttitude(1.1, EulerAngles.FromRadians(0, 0, double.PositiveInfinity));
        _history.Add(new PoseSample { Kind = (PoseSampleKind)9, Time = Seconds(1.1) });

        Assert.Equal(7, _history.Refused);
        Assert.Equal(PoseLookup.NotYet, _history.Find(Seconds(1.05), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1), out Pose pose));
        Assert.Equal(100, pose.Position.AltitudeAmslMetres, 1e-6);
    }

    [Fact]
    public void Find_VelocityNotANumber_GoesStraight()
    {
        AddAttitude(1, default);
        AddAttitude(2, default);
        AddPosition(1, Place(altitude: 100), new NedVector(double.NaN, 0, 0));
        AddPosition(2, Place(altitude: 110), default);
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.5), out Pose pose));
        Assert.Equal(105, pose.Position.AltitudeAmslMetres, 1e-6);
        Assert.Equal(-10, pose.VelocityNed.Down, 1e-6);
    }

    [Fact]
    public void Add_TimeJumpsBack_ForgetsWhatWasBefore()
    {
        AddBoth(100);
        AddBoth(100.2);
        AddBoth(50);
        AddBoth(50.2);

        Assert.Equal(2, _history.Restarts);
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(50.1), out _));
        Assert.Equal(PoseLookup.NotYet, _history.Find(Seconds(100.1), out _));
    }

    [Fact]
    public void Add_OneSampleFarAhead_DoesNotStopTheOthers()
    {
        AddBoth(1);
        AddBoth(1000);
        AddBoth(1.2);
        AddBoth(1.4);

        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.3), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.1), out _));
        Assert.Equal((2, 0), (_history.Refused, _history.Restarts));
    }

    [Theory]
    [InlineData(98)]
    [InlineData(-3600)]
    [InlineData(3700)]
    public void Add_OneSampleOfAnotherTime_IsRefusedAndForgetsNothing(double time)
    {
        AddBoth(100);
        AddBoth(100.2);
        AddBoth(time - 0.01);
        AddBoth(100.4);
        AddBoth(time - 0.01);
        AddBoth(time - 0.01);
        AddBoth(100.6);

        Assert.Equal((6, 0), (_history.Refused, _history.Restarts));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(100.1), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(100.5), out _));
    }

    // As after a pause of the link: the second one counts, and the first with it.
    [Fact]
    public void Add_TwoSamplesFarAheadThatAgree_BothCountAndNothingIsForgotten()
    {
        AddBoth(1);
        AddBoth(1.2);
        AddBoth(20);
        AddBoth(20.2);

        Assert.Equal((0, 0), (_history.Refused, _history.Restarts));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.1), out _));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(20), out _));
        Assert.Equal(PoseLookup.Gap, _history.Find(Seconds(10), out _));
    }

    [Fact]
    public void Add_ManyMoreThanFit_KeepsTheNewestAndAllocatesNothing()
    {
        Assert.Equal(0, Allocated.By(() =>
        {
            for (int i = 0; i < 3000; i++)
                AddBoth(i * 0.02);
            _history.Find(Seconds(59), out _);
        }));
        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(58), out _));
        Assert.Equal(PoseLookup.TooOld, _history.Find(Seconds(30), out _));
    }

    [Fact]
    public void Find_RandomOrder_AgreesWithSamplesInOrder()
    {
        const int Seed = 3;
        var random = new Random(Seed);
        var expected = new PoseHistory(TimeSpan.FromSeconds(1));
        int[] order = Enumerable.Range(0, 100).Select(i => (At: i + (random.NextDouble() * 8), i)).OrderBy(p => p.At)
            .Select(p => p.i).ToArray();
        for (int i = 0; i < 100; i++)
        {
            Put(expected, i);
            Put(_history, order[i]);
        }

        for (int i = 0; i < 200; i++)
        {
            TimeSpan time = Seconds(random.NextDouble() * 4.95);
            Assert.Equal(PoseLookup.Known, expected.Find(time, out Pose a));
            Assert.Equal(PoseLookup.Known, _history.Find(time, out Pose b));
            Assert.True(a.Position.AltitudeAmslMetres == b.Position.AltitudeAmslMetres, $"seed {Seed}");
            Assert.True(a.Attitude.Z == b.Attitude.Z, $"seed {Seed}");
        }

        static void Put(PoseHistory history, int i)
        {
            history.Add(
                new PoseSample
                {
                    Kind = PoseSampleKind.Position,
                    Time = Seconds(i * 0.05),
                    Position = Place(100 + (i * i % 17))
                });
            history.Add(
                new PoseSample
                {
                    Kind = PoseSampleKind.Attitude,
                    Time = Seconds(i * 0.05),
                    Attitude = EulerAngles.FromRadians(0, 0, i * i % 5)
                });
        }
    }

    private static TimeSpan Seconds(double seconds)
        => TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));

    private static GeodeticPosition Place(double altitude = 100) => GeodeticPosition.FromRadians(0.8, 0.1, altitude);

    private void AddBoth(double time)
    {
        AddPosition(time, Place(), default);
        AddAttitude(time, default);
    }

    private void AddPosition(double time, GeodeticPosition position, NedVector velocity)
        => _history.Add(
            new PoseSample
            {
                Kind = PoseSampleKind.Position,
                Time = Seconds(time),
                Position = position,
                VelocityNed = velocity
            });

    private void AddAttitude(double time, EulerAngles attitude)
        => _history.Add(new PoseSample { Kind = PoseSampleKind.Attitude, Time = Seconds(time), Attitude = attitude });
}
