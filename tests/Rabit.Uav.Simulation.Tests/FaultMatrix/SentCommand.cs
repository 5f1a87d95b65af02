using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>A frame of ours that moves the vehicle or changes its mode.</summary>
/// <param name="Time">When it was sent, by the clock of the run.</param>
/// <param name="What">The command or the message.</param>
/// <param name="ChangesMode">Whether it changes the mode: a mode command, arming or taking off.</param>
internal sealed record SentCommand(TimeSpan Time, string What, bool ChangesMode)
{
    public static SentCommand? Of(in MavlinkFrame frame, TimeSpan time)
    {
        if (frame.TryDecode(out CommandLong command))
            return Of(command.Command, changesByFlag: false, time);
        if (frame.TryDecode(out CommandInt commandInt))
            return Of(commandInt.Command, ((int)commandInt.Param2 & 1) != 0, time);
        if (frame.TryDecode(out SetPositionTargetGlobalInt _) || frame.TryDecode(out SetPositionTargetLocalNed _))
            return new SentCommand(time, "set-point", ChangesMode: false);
        return null;
    }

    private static SentCommand? Of(MavCmd command, bool changesByFlag, TimeSpan time) => command switch
    {
        MavCmd.DoSetMode or MavCmd.ComponentArmDisarm or MavCmd.NavTakeoff or MavCmd.NavLand
            or MavCmd.NavReturnToLaunch => new SentCommand(time, command.ToString(), ChangesMode: true),
        MavCmd.DoReposition => new SentCommand(time, command.ToString(), changesByFlag),
        MavCmd.DoChangeSpeed or MavCmd.ConditionYaw => new SentCommand(time, command.ToString(), ChangesMode: false),
        _ => null,
    };
}
