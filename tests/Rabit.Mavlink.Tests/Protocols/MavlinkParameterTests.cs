using System;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>The two ways to put an integer into a float field.</summary>
public class MavlinkParameterTests
{
    [Theory]
    [InlineData(MavParamType.Int32, -2147483648.0)]
    [InlineData(MavParamType.Int32, 454671160.0)]
    [InlineData(MavParamType.Uint32, 4294967295.0)]
    [InlineData(MavParamType.Int16, -32768.0)]
    [InlineData(MavParamType.Uint16, 65535.0)]
    [InlineData(MavParamType.Int8, -128.0)]
    [InlineData(MavParamType.Uint8, 255.0)]
    [InlineData(MavParamType.Real32, 0.5)]
    public void Bytewise_RoundTrips(MavParamType type, double value) =>
        Assert.Equal(value, MavlinkParameter.Decode(MavlinkParameter.Encode(value, type, MavlinkParameterEncoding.Bytewise), type, MavlinkParameterEncoding.Bytewise));

    [Fact]
    public void CCast_HoldsTwentyFourBitsAndSaysWhenItDoesNot()
    {
        Assert.Equal(16_777_216, MavlinkParameter.Decode(MavlinkParameter.Encode(16_777_216, MavParamType.Int32, MavlinkParameterEncoding.CCast), MavParamType.Int32, MavlinkParameterEncoding.CCast));
        Assert.Throws<ArgumentOutOfRangeException>(() => MavlinkParameter.Encode(16_777_217, MavParamType.Int32, MavlinkParameterEncoding.CCast));
        Assert.Throws<ArgumentOutOfRangeException>(() => MavlinkParameter.Encode(300, MavParamType.Uint8, MavlinkParameterEncoding.Bytewise));
        Assert.Throws<ArgumentOutOfRangeException>(() => MavlinkParameter.Encode(double.NaN, MavParamType.Int8, MavlinkParameterEncoding.Bytewise));
    }
}
