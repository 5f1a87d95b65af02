using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Who divides the lanes, when, and whose division holds.</summary>
public sealed class GroupDivisionTests
{
    private const int Lanes = 12;

    private bool _isEnough = true;
    private bool _isHalved;
    private int _divided;
    private readonly GroupDivision _division = new();
    private readonly Dictionary<byte, GroupReport> _others = [];
    private TimeSpan _now = TimeSpan.FromSeconds(100);
    private GroupReport _own = Report();

    [Fact]
    public void Update_AtTheStart_WaitsForOthers()
    {
        Update(seconds: 2);
        Assert.Equal(0, _division.Author);
        Update(seconds: 1);
        Assert.Equal(5, _division.Author);
    }

    [Fact]
    public void Update_LowerIdIsReceived_DividesNothing()
    {
        _others[4] = Report();
        Update(seconds: 10);
        Assert.Equal(0, _division.Author);
    }

    [Theory]
    [InlineData(GroupMemberState.Waiting)]
    [InlineData(GroupMemberState.Leaving)]
    public void Update_LowerIdDoesNotSearch_Divides(GroupMemberState state)
    {
        _others[4] = Report() with { State = state };
        Update(seconds: 3);
        Assert.Equal(5, _division.Author);
    }

    [Fact]
    public void Update_DoesNotSearch_DividesNothing()
    {
        _own.State = GroupMemberState.Waiting;
        _others[6] = Report();
        Update(seconds: 10);
        Assert.Equal(0, _division.Author);
    }

    [Fact]
    public void Update_AuthorLeavesWithoutLanes_ItsDivisionIsKept()
    {
        _others[4] = Report();
        Receive(source: 4, number: 7, author: 4, new LaneShare(4, 0, 6), new LaneShare(5, 6, 6));
        int changes = _division.Changes;
        _others[4] = Report() with { State = GroupMemberState.Leaving, MetresLeft = 0 };
        Update(seconds: 5);
        Assert.Equal(5, _division.Author);
        Assert.Equal(new LaneShare(5, 6, 6), _division.ShareOf(5));
        Assert.Equal(changes, _division.Changes);
    }

    [Fact]
    public void Update_LowerIdIsNotReceivedAnyMore_Divides()
    {
        _others[4] = Report();
        Update(seconds: 10);
        _others.Clear();
        Update(seconds: 1);
        Assert.Equal(5, _division.Author);
        Assert.Equal(Lanes, _division.ShareOf(5).Count);
    }

    [Fact]
    public void Update_SameVehicles_KeepsTheDivisionAndRepeatsIt()
    {
        _others[6] = Report();
        Update(seconds: 3);
        ushort number = _division.Number;
        int sent = Update(seconds: 20);
        Assert.Equal(number, _division.Number);
        Assert.InRange(sent, 9, 11);
    }

    [Fact]
    public void Update_Alone_SendsNothing()
        => Assert.Equal(0, Update(seconds: 20));

    [Fact]
    public void Update_OneComes_DividesAgain()
    {
        Update(seconds: 3);
        _others[6] = Report();
        Update(seconds: 0.2);
        Assert.Equal([6, 6], _division.Shares.Select(s => s.Count));
    }

    [Fact]
    public void Update_OneLeavesWithLanes_DividesAgain()
    {
        _others[6] = Report();
        Update(seconds: 3);
        _others[6] = Report() with { State = GroupMemberState.Leaving };
        Update(seconds: 0.2);
        Assert.Equal(Lanes, _division.ShareOf(5).Count);
    }

    [Fact]
    public void Update_OneLeavesWithoutLanes_KeepsTheDivision()
    {
        _others[6] = Report();
        Update(seconds: 3);
        ushort number = _division.Number;
        _others[6] = Report() with { State = GroupMemberState.Leaving, MetresLeft = 0 };
        Update(seconds: 20);
        Assert.Equal(number, _division.Number);
    }

    // 1000 m at 6 m/s: 167 s. It is asked for once in half a minute, and taken only where it is better.
    [Theory]
    [InlineData(100, 400, true, true)]
    [InlineData(100, 400, false, false)]
    [InlineData(100, 200, true, false)]
    [InlineData(200, 400, true, false)]
    public void Update_EnergyOfOneIsTooLittle_DividesAgainWhereThatHelps(
        double secondsOfOne, double secondsOfOther, bool isEnough, bool isDivided)
    {
        (_isEnough, _own.SearchTime) = (isEnough, TimeSpan.FromSeconds(secondsOfOther));
        _others[6] = Report() with { SearchTime = TimeSpan.FromSeconds(secondsOfOther) };
        Update(seconds: 40);
        (ushort number, int divided) = (_division.Number, _divided);
        _isHalved = true;
        _others[6] = _others[6] with { SearchTime = TimeSpan.FromSeconds(secondsOfOne) };
        Update(seconds: 25);
        Assert.Equal(isDivided, _division.Number != number);
        Assert.InRange(_divided - divided, 0, 1);
    }

    [Fact]
    public void Update_AfterARestart_TakesANumberThatTheOthersFollow()
    {
        _others[6] = Report() with { DivisionAuthor = 5, DivisionNumber = 40_000 };
        Update(seconds: 3);
        Assert.Equal(40_001, _division.Number);
    }

    [Fact]
    public void Receive_OfTheAuthor_IsTaken()
    {
        Receive(source: 2, number: 1, author: 2, new LaneShare(5, 3, 4));
        Assert.Equal(2, _division.Author);
        Assert.Equal(new LaneShare(5, 3, 4), _division.ShareOf(5));
    }

    [Fact]
    public void Receive_OlderNumber_IsNotTaken()
    {
        Receive(source: 2, number: 2, author: 2, new LaneShare(5, 3, 4));
        Receive(source: 2, number: 1, author: 2, new LaneShare(5, 0, 4));
        Receive(source: 2, number: 2, author: 2, new LaneShare(5, 0, 4));
        Assert.Equal(3, _division.ShareOf(5).First);
    }

    [Fact]
    public void Receive_NumberAfterTheLast_IsNewer()
    {
        Receive(source: 2, number: 65535, author: 2, new LaneShare(5, 3, 4));
        Receive(source: 2, number: 0, author: 2, new LaneShare(5, 0, 4));
        Assert.Equal(0, _division.ShareOf(5).First);
    }

    [Fact]
    public void Receive_NotOfTheAuthorOrBeyondTheLanes_IsRefused()
    {
        Receive(source: 3, number: 1, author: 2, new LaneShare(5, 0, 4));
        Receive(source: 5, number: 1, author: 5, new LaneShare(5, 0, 4));
        Receive(source: 2, number: 1, author: 2, new LaneShare(5, 10, 3));
        Assert.Equal(3, _division.Refused);
        Assert.Equal(0, _division.Author);
    }

    private void Receive(byte source, ushort number, byte author, params LaneShare[] shares)
        => _division.Receive(
            source, new LaneDivision { Number = number, Shares = [.. shares] }, ownSystemId: 5, author, Lanes);

    // As often as Mission Control does; gives how often it was sent.
    private int Update(double seconds)
    {
        int sent = 0;
        for (TimeSpan end = _now + TimeSpan.FromSeconds(seconds); _now < end; _now += TimeSpan.FromSeconds(0.2))
        {
            (byte, GroupReport)[] present = _others.OrderBy(o => o.Key).Select(o => (o.Key, o.Value)).ToArray();
            _own.DivisionNumber = _division.Number;
            double LeftOf(byte id) => id == 5 ? _own.MetresLeft : _others[id].MetresLeft;
            sent += _division.Update(_own, 5, present, LeftOf, Equally, mayBalance: true, _now) ? 1 : 0;
        }

        return sent;
    }

    private (ImmutableArray<LaneShare> Shares, bool IsEnough) Equally(
        IReadOnlyList<(byte SystemId, GroupReport Report)> members)
    {
        _divided++;
        int count = Lanes / members.Count;
        var shares = members.Select((m, i) => new LaneShare(m.SystemId, i * count, count)).ToImmutableArray();
        return (_isHalved ? [.. shares.Select(s => s with { Count = s.Count / 2 })] : shares, _isEnough);
    }

    private static GroupReport Report()
        => new() { State = GroupMemberState.Available, SpeedMetresPerSecond = 6, MetresLeft = 1000 };
}
