using System;
using System.Linq;
using System.Reflection;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class PlainValueTests
{
    [Fact]
    public void Messages_Everyone_HoldsOnlyValuesAllTheWayDown()
    {
        foreach (Type type in MessageTypes.ById.Values)
            AssertPlain(type, type.Name);
    }

    [Fact]
    public void Heartbeat_Properties_AreWhatAUserExpects()
    {
        var heartbeat = new Heartbeat
        {
            CustomMode = 4,
            Type = MavType.Quadrotor,
            Autopilot = MavAutopilot.Ardupilotmega,
            BaseMode = MavModeFlag.CustomModeEnabled | MavModeFlag.SafetyArmed,
            SystemStatus = MavState.Active,
            MavlinkVersion = 3,
        };
        var payload = new byte[Heartbeat.MavlinkMaxLength];
        heartbeat.Encode(payload);
        Assert.Equal(new byte[] { 4, 0, 0, 0, 2, 3, 129, 4, 3 }, payload);
    }

    [Fact]
    public void Enum_NarrowerOnTheWire_KeepsNumbersWithoutAName()
    {
        var message = default(WifiConfigAp);
        var payload = new byte[WifiConfigAp.MavlinkMaxLength];
        payload[96] = 0xFF;
        message.Decode(payload);
        Assert.Equal(-1, (int)message.Mode);
        var encoded = new byte[payload.Length];
        message.Encode(encoded);
        Assert.Equal(payload, encoded);
    }

    [Theory]
    [InlineData(typeof(MavModeFlag), typeof(uint), true)]
    [InlineData(typeof(MavType), typeof(int), false)]
    [InlineData(typeof(MavProtocolCapability), typeof(ulong), true)]
    [InlineData(typeof(MavFuelType), typeof(uint), false)]
    [InlineData(typeof(WifiConfigApMode), typeof(int), false)]
    public void Enum_UnderlyingType_HoldsEveryValueOfItsFields(Type type, Type underlying, bool isFlags)
    {
        Assert.Equal(underlying, Enum.GetUnderlyingType(type));
        Assert.Equal(isFlags, type.GetCustomAttributes(typeof(FlagsAttribute), false).Length != 0);
    }

    private static void AssertPlain(Type type, string path)
    {
        if (type.IsPrimitive || type.IsEnum)
            return;
        Assert.True(type.IsValueType, path);
        foreach (FieldInfo field
            in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            AssertPlain(field.FieldType, path + "." + field.Name);
    }
}
