using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>What is sent of the energy to the ground station.</summary>
public sealed class EnergyTelemetryTests : IDisposable
{
    private static readonly EnergyStatus Energy = new()
    {
        IsKnown = true,
        ChargeLeft = 0.62,
        ChargeLeftDeviation = 0.04,
        ChargeHome = 0.21,
        ChargeHomeDeviation = 0.03,
        TimeToReturn = TimeSpan.FromSeconds(312),
        TimeHome = TimeSpan.FromSeconds(95.5),
        CapacityFraction = 0.84,
    };

    private readonly HealthRig _rig = new(new VirtualTime(1));

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Energy_Known_IsSentOneValueASecondInTurn()
    {
        _rig.PostAddress();
        Fly(Energy, 21);

        NamedValueFloat[] sent = _rig.Sink.MessagesOf<NamedValueFloat>().ToArray();
        Assert.InRange(sent.Length, 21, 22);
        Assert.Equal(
            [
                ("EnLeft", 62f), ("EnLeftSd", 4f), ("EnToHome", 21f), ("EnToHomeSd", 3f), ("EnReturnIn", 312f),
                ("EnTimeHome", 95.5f), ("EnCapacity", 84f),
            ],
            sent.Take(7).Select(m => (m.Name.ToString(), m.Value)));
        Assert.Equal(sent.Take(7).Select(m => m.Name), sent.Skip(7).Take(7).Select(m => m.Name));
        Assert.All(
            sent.Skip(1).Zip(sent, (b, a) => b.TimeBootMs - a.TimeBootMs), ms => Assert.InRange(ms, 990u, 1010u));
        Assert.All(
            _rig.Sink.Frames.Where(f => f.Frame.MessageId == NamedValueFloat.MavlinkId),
            f => Assert.Equal((1, 191), (f.Frame.SystemId, f.Frame.ComponentId)));
    }

    [Fact]
    public void Energy_NotKnown_IsNotSent()
    {
        EnergyStatus unknown = Energy;
        unknown.IsKnown = false;
        _rig.PostAddress();
        Fly(unknown, 10);
        Assert.Empty(_rig.Sink.MessagesOf<NamedValueFloat>());
    }

    [Fact]
    public void Energy_MissionControlHangs_IsSentForFiveSecondsOnly()
    {
        _rig.PostAddress();
        _rig.PostEnergy(Energy);
        _rig.Fly(20);
        Assert.InRange(_rig.Sink.MessagesOf<NamedValueFloat>().Count, 5, 6);
    }

    [Fact]
    public void Energy_OwnAddressNotKnown_IsNotSent()
    {
        Fly(Energy, 5);
        Assert.Empty(_rig.Sink.Frames);
    }

    [Fact]
    public void Energy_HomeAgainstTooStrongAWind_WhatIsNotFiniteIsLeftOut()
    {
        EnergyStatus outOfReach = Energy;
        (outOfReach.ChargeHome, outOfReach.ChargeHomeDeviation) = (double.PositiveInfinity, double.NaN);
        (outOfReach.TimeHome, outOfReach.TimeToReturn) = (TimeSpan.MaxValue, TimeSpan.Zero);
        _rig.PostAddress();
        Fly(outOfReach, 9);
        Assert.Equal(
            [("EnLeft", 62f), ("EnLeftSd", 4f), ("EnReturnIn", 0f), ("EnCapacity", 84f)],
            _rig.Sink.MessagesOf<NamedValueFloat>().Take(4).Select(m => (m.Name.ToString(), m.Value)));
    }

    private void Fly(EnergyStatus energy, int seconds)
    {
        for (int i = 0; i < seconds; i++)
        {
            _rig.PostEnergy(energy);
            _rig.Fly(1);
        }
    }
}
