using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Two vehicles with one system id, as a third one receives them.</summary>
public sealed class GroupMembersTests
{
    private static readonly LocalNedFrame Frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);

    private readonly GroupMembers _members = new(TimeSpan.FromSeconds(4.5));

    [Fact]
    public void Receive_TwoWithOneSystemId_TheFirstCountsAndTheSecondIsRefusedAndNamed()
    {
        for (int second = 0; second < 10; second++)
        {
            Receive(second, eastMetres: 0);
            Receive(second + 0.5, eastMetres: 40);
        }

        Assert.InRange(_members.FindTwice(2, Time(10))!.Value, 39.9, 40.1);
        Assert.Equal(10, _members.Refused);
        Assert.Equal(0, EastOf(_members.Present(Time(10)).Single().Report), 0.01);
    }

    [Fact]
    public void Receive_SecondIsGone_IsForgottenAfterHalfAMinute()
    {
        Receive(0, eastMetres: 0);
        Receive(0.5, eastMetres: 40);
        for (int second = 1; second <= 32; second++)
            Receive(second, eastMetres: 0);

        Assert.NotNull(_members.FindTwice(2, Time(30)));
        Assert.Null(_members.FindTwice(2, Time(32)));
    }

    [Fact]
    public void Receive_OneWhosePositionBecomesBetter_IsNoSecondOneAndCountsAgain()
    {
        Receive(0, eastMetres: 0);
        for (int second = 1; second <= 8; second++)
        {
            Receive(second, eastMetres: 12);
            Assert.Null(_members.FindTwice(2, Time(second)));
        }

        Assert.Equal(12, EastOf(_members.Present(Time(8)).Single().Report), 0.01);
        Assert.Equal(4, _members.Refused);
    }

    [Fact]
    public void Receive_FirstFallsSilent_TheSecondIsTheVehicleOfThatSystemId()
    {
        Receive(0, eastMetres: 0);
        Receive(0.5, eastMetres: 40);
        Receive(1, eastMetres: 0);
        for (int second = 2; second <= 40; second++)
            Receive(second, eastMetres: 40);

        Assert.Equal(40, EastOf(_members.Present(Time(40)).Single().Report), 0.01);
        Assert.Null(_members.FindTwice(2, Time(40)));
    }

    // Nothing is shared with it, but it is in the same air.
    [Fact]
    public void Receive_OfOtherLanes_IsNoMemberAndKnownWhileItIsReceived()
    {
        for (int second = 0; second < 3; second++)
            Receive(second, eastMetres: 40, lanesKey: 8);

        Assert.Empty(_members.All);
        Assert.Equal(3, _members.Refused);
        Assert.Equal(2, Assert.Single(_members.Elsewhere(Time(3))));
        Assert.Equal(40, EastOf(_members.PresentTraffic(Time(3)).Single().Traffic.Report), 0.01);
        Assert.Empty(_members.Elsewhere(Time(8)));
        Assert.Empty(_members.PresentTraffic(Time(8)));

        Receive(9, eastMetres: 40, lanesKey: 8);
        Receive(9.5, eastMetres: 40);
        Assert.Empty(_members.Elsewhere(Time(10)));
        Assert.Single(_members.Present(Time(10)));
    }

    private static TimeSpan Time(double seconds) => TimeSpan.FromSeconds(seconds);

    private static double EastOf(in GroupReport report) => Frame.ToNed(report.LandingPlace).East;

    private void Receive(double seconds, double eastMetres, uint lanesKey = 7) => _members.Receive(
        new Envelope<GroupReport>
        {
            SourceSystemId = 2,
            SentTime = Time(seconds),
            Content = new GroupReport
            {
                LanesKey = lanesKey,
                LandingPlace = Frame.ToGeodetic(new NedPosition(0, eastMetres, 0)),
            },
        },
        ownSystemId: 1, lanesKey: 7, Time(seconds));
}
