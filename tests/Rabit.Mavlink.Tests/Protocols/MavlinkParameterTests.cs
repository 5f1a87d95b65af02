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
        Assert.Equal(value, MavlinkParameter.Decode(
            MavlinkParameter.Encode(value, type, MavlinkParameterEncoding.Bytewise), type,
            MavlinkParameterEncoding.Bytewise));

    [Theory]
    [InlineData("CAL_ACC0_XOFF", true)]
    [InlineData("CAL_GYRO2_ZOFF", true)]
    [InlineData("CAL_MAG1_YODIAG", true)]
    [InlineData("CAL_BARO3_OFF", true)]
    [InlineData("ASPD_SCALE_1", true)]
    [InlineData("EKF2_MAG_DECL", true)]
    [InlineData("CAL_ACC0_ID", false)]
    [InlineData("CAL_MAG_COMP", false)]
    [InlineData("CAL_ACC", false)]
    [InlineData("SENS_BOARD_X_OFF", false)]
    public void Hash_LeavesOutWhatPx4ChangesByItself(string name, bool isVolatile)
        => Assert.Equal(isVolatile, MavlinkParameterHash.IsVolatile(name));

    [Fact]
    public void CCast_HoldsTwentyFourBitsAndSaysWhenItDoesNot()
    {
        Assert.Equal(16_777_216, MavlinkParameter.Decode(
            MavlinkParameter.Encode(16_777_216, MavParamType.Int32, MavlinkParameterEncoding.CCast), MavParamType.Int32,
            MavlinkParameterEncoding.CCast));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => MavlinkParameter.Encode(16_777_217, MavParamType.Int32, MavlinkParameterEncoding.CCast));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => MavlinkParameter.Encode(300, MavParamType.Uint8, MavlinkParameterEncoding.Bytewise));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => MavlinkParameter.Encode(double.NaN, MavParamType.Int8, MavlinkParameterEncoding.Bytewise));
    }
}
