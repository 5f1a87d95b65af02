using System;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Routing;

public class MavlinkDuplicateFilterTests
{
    private readonly MavlinkDuplicateFilter _filter = new();

    [Theory]
    [InlineData(0, true)]
    [InlineData(500, true)]
    [InlineData(501, false)]
    public void IsDuplicate_SameFrameAfter_WithinTheWindowOnly(int milliseconds, bool expected)
    {
        Assert.False(_filter.IsDuplicate(Beat(sequence: 3), At(1000)));
        Assert.Equal(expected, _filter.IsDuplicate(Beat(sequence: 3), At(1000 + milliseconds)));
        Assert.Equal(expected ? 1 : 0, _filter.Duplicates);
    }

    [Fact]
    public void IsDuplicate_AnyOtherFrame_IsNone()
    {
        MavlinkFrame[] frames =
        [
            Beat(1), Beat(2), Beat(1, system: 2), Beat(1, component: 2),
            MavlinkFrame.Create(new Heartbeat { CustomMode = 1 }, 1, 1, 1),
            MavlinkFrame.Create(default(Heartbeat), 1, 1, 1, MavlinkVersion.V1),
            MavlinkFrame.Create(new Attitude { Yaw = 1 }, 1, 1, 1),
            MavlinkFrame.Create(new Attitude { Yaw = 1, Yawspeed = 1 }, 1, 1, 1),
        ];

        Assert.All(frames, f => Assert.False(_filter.IsDuplicate(f, At(0))));
        Assert.All(frames, f => Assert.True(_filter.IsDuplicate(f, At(1))));
    }

    [Theory]
    [InlineData(127, true)]
    [InlineData(128, false)]
    [InlineData(255, false)]
    public void IsDuplicate_SameAfterManyFramesOfItsSender_IsANewOne(int between, bool expected)
    {
        _filter.IsDuplicate(Beat(0), At(0));
        for (int n = 1; n <= between; n++)
            _filter.IsDuplicate(Beat((byte)n), At(n));

        Assert.Equal(expected, _filter.IsDuplicate(Beat(0), At(between)));
    }

    [Fact]
    public void IsDuplicate_SenderThatSaysTheSameFast_LosesNothing()
    {
        // A circle of sequence numbers in 128 ms, without a change in what is said.
        for (int n = 0; n < 10_000; n++)
            Assert.False(_filter.IsDuplicate(Beat((byte)n), TimeSpan.FromMilliseconds(n / 2.0)));
    }

    [Fact]
    public void IsDuplicate_FullNetOf25Vehicles_EveryCopyIsFound()
    {
        // 25 vehicles with 100 frames a second each; the copy comes 80 ms later.
        for (int n = 0; n < 10_000; n++)
        {
            Assert.False(_filter.IsDuplicate(OfVehicle(n), TimeSpan.FromMilliseconds(n * 0.4)));
            if (n >= 200)
                Assert.True(_filter.IsDuplicate(OfVehicle(n - 200), TimeSpan.FromMilliseconds(n * 0.4)));
        }

        static MavlinkFrame OfVehicle(int n) => Beat((byte)(n / 25), system: (byte)(1 + (n % 25)));
    }

    [Fact]
    public void Remember_FrameThatIsSent_ItsEchoIsKnown()
    {
        _filter.Remember(Beat(9), At(0));

        Assert.True(_filter.Contains(Beat(9), At(400)));
        Assert.False(_filter.Contains(Beat(9), At(600)));
        Assert.False(_filter.Contains(Beat(8), At(400)));
        Assert.True(_filter.IsDuplicate(Beat(9), At(400)));
    }

    [Fact]
    public void IsDuplicate_Always_AllocatesNothing()
    {
        int n = 0;
        Check();
        Assert.Equal(0, Allocated.By(Check));

        void Check()
        {
            for (int i = 0; i < 1000; i++)
                _filter.IsDuplicate(Beat((byte)n), At(n++));
        }
    }

    [Fact]
    public void Constructor_WindowOfZero_Throws()
        => Assert.Throws<ArgumentOutOfRangeException>("window", () => new MavlinkDuplicateFilter(TimeSpan.Zero));

    private static MavlinkFrame Beat(byte sequence, byte system = 1, byte component = 1)
        => MavlinkFrame.Create(default(Heartbeat), system, component, sequence);

    private static TimeSpan At(int milliseconds) => TimeSpan.FromMilliseconds(milliseconds);
}
