using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Says once that --fixed-wing has no effect: the vehicle is none.</summary>
internal sealed class FixedWingNotice(OperatorChoices choices, Action<string> say)
{
    private bool _isSaid;

    public void Check(in VehicleState vehicle)
    {
        if (_isSaid || choices.LoiterRadiusMetres is null || vehicle.SystemId == 0
            || vehicle.VehicleType == MavType.FixedWing)
            return;
        _isSaid = true;
        say($"--fixed-wing is ignored: the autopilot says that it is a {vehicle.VehicleType}");
    }
}
