using System;
using System.Linq;
using Xunit;

namespace Rabit.Mavlink.Tests.Signing;

public class MavlinkSigningClockTests
{
    private const long Second = MavlinkSigningClock.TicksPerSecond;
    private const long Hour = 3600 * Second;

    private readonly TwoSlots _slots = new();

    [Fact]
    public void ToTimestamp_KnownTimes_CountsFrom2015InTensOfMicroseconds()
    {
        Assert.Equal(0, MavlinkSigningClock.ToTimestamp(new DateTime(2015, 1, 1, 0, 0, 0, DateTimeKind.Utc)));
        Assert.Equal(
            86_400L * Second, MavlinkSigningClock.ToTimestamp(new DateTime(2015, 1, 2, 0, 0, 0, DateTimeKind.Utc)));
        Assert.Equal(0, MavlinkSigningClock.ToTimestamp(new DateTime(1970, 1, 1, 0, 0, 0, DateTimeKind.Utc)));
        Assert.Equal(Keys.Noon, MavlinkSigningClock.ToTimestamp(MavlinkSigningClock.ToUtc(Keys.Noon)));
    }

    [Fact]
    public void Advance_ValidWallClock_IsFollowed()
    {
        var clock = new MavlinkSigningClock();
        for (int second = 0; second < 100; second++)
        {
            Advance(clock, Keys.Noon + (second * Second), second);
            Assert.Equal(Keys.Noon + (second * Second), clock.Timestamp);
        }
    }

    [Fact]
    public void Advance_WallClockStepsOneHourBack_NeverGoesBackNorStops()
    {
        var clock = new MavlinkSigningClock();
        Advance(clock, Keys.Noon, 0);
        long last = clock.Next();
        for (int second = 1; second <= 7300; second++)
        {
            Advance(clock, Keys.Noon - Hour + (second * Second), second);
            long next = clock.Next();
            Assert.True(next - last >= Second / 2, $"second {second}: {next} after {last}");
            last = next;
        }

        // At half speed the hour is caught up in two.
        Assert.Equal(Keys.Noon - Hour + (7300 * Second), last);
    }

    [Fact]
    public void Advance_WallClockStepsForward_IsFollowedAtOnce()
    {
        var clock = new MavlinkSigningClock();
        Advance(clock, 5, 0);
        Advance(clock, Keys.Noon, 1);

        Assert.Equal(Keys.Noon, clock.Next());
    }

    [Fact]
    public void Advance_ElapsedTimeGoesBack_IsHeldForNoTime()
    {
        MavlinkSigningClock clock = Keys.ClockAt(Keys.Noon);
        Advance(clock, 0, 10);
        Advance(clock, 0, 3);

        Assert.Equal(Keys.Noon + (5 * Second), clock.Timestamp);
    }

    [Fact]
    public void Advance_LocalTime_IsRefused() =>
        Assert.Throws<ArgumentException>(
            () => new MavlinkSigningClock()
                .Advance(new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Local), TimeSpan.Zero));

    [Fact]
    public void Next_MoreFramesThanTicks_NeverGivesATimeTwice()
    {
        MavlinkSigningClock clock = Keys.ClockAt(Keys.Noon);
        long[] given = Enumerable.Range(0, 1000).Select(_ => clock.Next()).ToArray();

        Assert.Equal(Enumerable.Range(0, 1000).Select(i => Keys.Noon + i), given);
    }

    [Fact]
    public void Next_EndOf48Bits_IsRefused()
    {
        MavlinkSigningClock clock = new((1L << 48) - 1);
        Advance(clock, 0, 0);
        clock.Next();

        Assert.Throws<InvalidOperationException>(() => clock.Next());
        Advance(clock, 0, 1_000_000);
        Assert.Throws<InvalidOperationException>(() => clock.Next());
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(1L << 48)]
    public void New_NotATimestamp_IsRefused(long earliest)
        => Assert.Throws<ArgumentOutOfRangeException>(() => new MavlinkSigningClock(earliest));

    [Fact]
    public void Advance_WithAStore_WritesBothPlacesInTurnAtLeastOnceAMinute()
    {
        var clock = new MavlinkSigningClock(_slots);
        int longest = 0;
        int lastWrite = 0;
        for (int second = 0; second < 600; second++)
        {
            int writes = _slots.Writes.Count;
            Advance(clock, Keys.Noon + (second * Second), second);
            if (_slots.Writes.Count == writes)
                continue;
            longest = Math.Max(longest, second - lastWrite);
            lastWrite = second;
        }

        Assert.InRange(longest, 20, 60);
        Assert.Equal(Enumerable.Range(0, _slots.Writes.Count).Select(i => i % 2), _slots.Writes);
        Assert.All(_slots.Slots, slot => Assert.Equal(12, slot.Length));
    }

    [Fact]
    public void New_PowerFailedAtAnyMoment_ContinuesAfterAllThatWasUsed()
    {
        // The computer has no clock of its own: each start finds itself in 1970.
        long last = -1;
        var random = new Random(3);
        for (int start = 0; start < 50; start++)
        {
            var clock = new MavlinkSigningClock(_slots);
            int seconds = random.Next(1, 90);
            for (int second = 0; second < seconds; second++)
            {
                Advance(clock, 0, second);
                long next = clock.Next();
                Assert.True(next > last, $"start {start}, second {second}: {next} after {last}");
                last = next;
            }
        }
    }

    [Fact]
    public void New_AfterSave_GoesOnWhereItEnded()
    {
        var clock = new MavlinkSigningClock(_slots);
        Advance(clock, Keys.Noon, 0);
        long last = clock.Next();
        Assert.True(clock.Save());

        var next = new MavlinkSigningClock(_slots);
        Advance(next, 0, 0);
        Assert.Equal(last + 1, next.Next());
    }

    [Fact]
    public void New_WallClockBeyondWhatWasStored_FollowsTheWallClock()
    {
        Advance(new MavlinkSigningClock(_slots), Keys.Noon, 0);

        var next = new MavlinkSigningClock(_slots);
        Advance(next, Keys.Noon + Hour, 0);
        Assert.Equal(Keys.Noon + Hour, next.Next());
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void New_OnePlaceTorn_GoesOnFromTheOther(int torn)
    {
        var clock = new MavlinkSigningClock(_slots);
        Advance(clock, Keys.Noon, 0);
        Advance(clock, Keys.Noon + (40 * Second), 40);
        _slots.Slots[torn][5] ^= 0x10;

        Assert.True(new MavlinkSigningClock(_slots).Timestamp >= Keys.Noon);
    }

    [Fact]
    public void New_TornWhileWritingTheNewer_WritesTheTornPlaceNext()
    {
        var clock = new MavlinkSigningClock(_slots);
        Advance(clock, Keys.Noon, 0);
        Advance(clock, Keys.Noon + (40 * Second), 40);
        _slots.Slots[1] = [1, 2, 3];
        _slots.Writes.Clear();

        Advance(new MavlinkSigningClock(_slots), Keys.Noon, 0);
        Assert.Equal([1], _slots.Writes);
    }

    [Fact]
    public void New_NothingUsableStored_StartsFromTheWallClock()
    {
        _slots.Slots[0] = new byte[12];
        _slots.Slots[1] = Enumerable.Repeat((byte)0xFF, 12).ToArray();
        var clock = new MavlinkSigningClock(_slots);
        Advance(clock, Keys.Noon, 0);

        Assert.Equal(Keys.Noon, clock.Next());
    }

    [Fact]
    public void Advance_StoreThatFails_IsCountedAndTriedAgain()
    {
        _slots.IsBroken = true;
        var clock = new MavlinkSigningClock(_slots);
        Advance(clock, Keys.Noon, 0);
        Advance(clock, Keys.Noon + 10, 0);
        Assert.Equal(1, clock.FailedSaves);
        Advance(clock, Keys.Noon + (2 * Second), 2);
        Assert.Equal(2, clock.FailedSaves);

        _slots.IsBroken = false;
        Advance(clock, Keys.Noon + (4 * Second), 4);
        Assert.Equal((2, 1), (clock.FailedSaves, _slots.Writes.Count));
    }

    [Fact]
    public void Advance_OthersAreFarAhead_StoresWhatWasAcceptedFromThem()
    {
        var clock = new MavlinkSigningClock(_slots);
        Advance(clock, Keys.Noon, 0);
        clock.Accept(Keys.Noon + Hour);
        Advance(clock, Keys.Noon + 1, 0);

        Assert.True(new MavlinkSigningClock(_slots).Timestamp > Keys.Noon + Hour);
    }

    [Fact]
    public void Save_WithoutAStore_IsFalse() => Assert.False(Keys.ClockAt(Keys.Noon).Save());

    private static void Advance(MavlinkSigningClock clock, long wall, double elapsedSeconds) =>
        clock.Advance(MavlinkSigningClock.ToUtc(wall), TimeSpan.FromSeconds(elapsedSeconds));
}
