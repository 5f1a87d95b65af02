using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace UavConsole.Tests;

/// <summary>An option that has no effect is said to have none.</summary>
public sealed class FixedWingNoticeTests
{
    [Theory]
    [InlineData(MavType.Quadrotor, 80.0, true)]
    [InlineData(MavType.FixedWing, 80.0, false)]
    [InlineData(MavType.Quadrotor, null, false)]
    public void Check_Vehicle_IsSaidOnceWhereTheOptionIsIgnored(MavType type, double? radius, bool isSaid)
    {
        var said = new List<string>();
        var notice = new FixedWingNotice(new OperatorChoices { LoiterRadiusMetres = radius }, said.Add);

        notice.Check(default);
        Assert.Empty(said);
        notice.Check(new VehicleState { SystemId = 1, VehicleType = type });
        notice.Check(new VehicleState { SystemId = 1, VehicleType = type });

        Assert.Equal(
            isSaid ? ["--fixed-wing is ignored: the autopilot says that it is a Quadrotor"] : [], said);
    }
}
