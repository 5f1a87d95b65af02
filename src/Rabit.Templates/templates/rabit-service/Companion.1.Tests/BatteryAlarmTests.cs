using System;
using Microsoft.Extensions.Options;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav;
using Rabit.Uav.Messages;
using Xunit;

namespace Companion._1.Tests;

/// <summary>Only the manager under test is in the reactor, in virtual time; the test plays the six managers.</summary>
public sealed class BatteryAlarmTests
{
    private readonly RabitReactor _reactor = new(new VirtualTime(seed: 1));
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<OwnAddress> _ownAddress;
    private readonly QueueReceiver<OutgoingFrame> _outgoing;

    public BatteryAlarmTests()
    {
        _reactor.Add(new BatteryAlarm(Options.Create(new BatteryAlarmOptions { LevelFraction = 0.3 })));
        _vehicle = _reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        _ownAddress = _reactor.Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
        _outgoing = _reactor.Workspace.Receive<OutgoingFrame>(MessageNames.OutgoingFrames);
        _reactor.Start();
        _ownAddress.Value = new OwnAddress { SystemId = 1, ComponentId = 191 };
        _ownAddress.Post();
    }

    [Theory]
    [InlineData(0.31)]
    [InlineData(double.NaN)]   // the autopilot does not know
    public void Battery_NotBelowTheLevel_IsNotWarnedOf(double remaining)
    {
        Post(remaining);

        Assert.False(_outgoing.TryPop(out _));
    }

    [Fact]
    public void Battery_BelowTheLevel_IsWarnedOfOnce()
    {
        Post(0.29);
        Post(0.28);

        Assert.True(_outgoing.TryPop(out OutgoingFrame warning));
        Assert.True(warning.Frame.TryDecode(out Statustext text));
        Assert.Equal("battery at 29 percent", text.Text.ToString());
        Assert.False(_outgoing.TryPop(out _));
    }

    private void Post(double remaining)
    {
        _vehicle.Value.BatteryRemaining = remaining;
        _vehicle.Post();
        _reactor.RunFor(TimeSpan.FromSeconds(1));   // virtual: no time passes
    }
}
