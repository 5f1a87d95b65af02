using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Our position, sent to ground and other vehicles.</summary>
public sealed class OwnPositionTests
{
    [Theory]
    [InlineData(1, 20)]
    [InlineData(10, 200)]
    [InlineData(0.5, 10)]
    [InlineData(0, 0)]
    public void Position_Known_GoesToEveryLinkAtItsRate(double hertz, int expected)
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2, o => o.PositionRateHz = hertz).As(1);
        Fly(rig, 20);
        Assert.InRange(rig.ReceivedFrames(0).Count, expected - 1, expected + 1);
        Assert.InRange(rig.ReceivedFrames(1).Count, expected - 1, expected + 1);
    }

    [Fact]
    public void Position_Content_IsThatOfTheVehicleFromOurAddress()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);
        Fly(rig, 1);
        MavlinkFrame frame = rig.ReceivedFrames(0)[0];
        Assert.Equal((1, 191), (frame.SystemId, frame.ComponentId));
        Assert.True(frame.TryDecode(out GlobalPositionInt position));
        Assert.Equal(
            (-353_632_610, 1_491_652_300, 584_100, 30_000),
            (position.Lat, position.Lon, position.Alt, position.RelativeAlt));
        Assert.Equal((150, -250, 5, 35_900), (position.Vx, position.Vy, position.Vz, position.Hdg));
    }

    [Fact]
    public void Position_OldOrAddressUnknown_IsNotSent()
    {
        using var rig = new CommunicationsRig(links: 1);
        Fly(rig, 3);
        Assert.Empty(rig.Received(0));
        rig.As(1);
        Fly(rig, 2);
        Assert.NotEmpty(rig.Received(0));
        rig.Run(TimeSpan.FromSeconds(3));
        rig.Received(0);
        rig.Run(TimeSpan.FromSeconds(10));
        Assert.Empty(rig.Received(0));
    }

    [Fact]
    public void Position_OnAReplay_IsNotCountedAsSent()
    {
        using RecordedFile file = RecordedFile.Open(LinkUrl.Parse($"tlog:{TestData.PathOf("px4-flight.tlog")}"));
        using CommunicationsRig rig = new CommunicationsRig(links: 0, o => o.RecordedFiles = [file]).As(1);
        Fly(rig, 5);
        Assert.Empty(rig.Manager.CountOwnFrames());
    }

    private static void Fly(CommunicationsRig rig, int seconds)
    {
        for (int i = 0; i < seconds * 10; i++)
        {
            rig.Post(new VehicleState
            {
                SystemId = 1,
                PositionTime = rig.Reactor.Now,
                Position = GeodeticPosition.FromDegrees(-35.363261, 149.16523, 584.1),
                HeightAboveHomeMetres = 30,
                VelocityNed = new NedVector(1.5, -2.5, 0.05),
                AttitudeTime = rig.Reactor.Now,
                Attitude = EulerAngles.FromRadians(0, 0, -1 * Angle.RadiansPerDegree),
            });
            rig.Run(TimeSpan.FromSeconds(0.1));
        }
    }
}
