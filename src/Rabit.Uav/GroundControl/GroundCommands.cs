using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.GroundControl;

/// <summary>The MAVLink commands that are ours, as requests of the operator.</summary>
internal static class GroundCommands
{
    private const double DegreesPerUnit = 1e-7;

    /// <summary>Reads a command.</summary>
    /// <param name="command">The command.</param>
    /// <param name="by">Who sent it, as text.</param>
    /// <param name="request">The request that it is.</param>
    /// <param name="refusal">Where it is none: UNSUPPORTED, or DENIED for parameters out of their range.</param>
    public static bool TryRead(
        in MavlinkCommand command, string by, out OperatorRequest? request, out MavResult refusal)
    {
        refusal = MavResult.Denied;
        request = command.Command switch
        {
            MavCmd.DoPauseContinue => command.Param1 switch
            {
                0 => Make(OperatorCommand.Hold, command, by),
                1 => Make(OperatorCommand.Continue, command, by),
                _ => null,
            },
            MavCmd.NavReturnToLaunch => Make(OperatorCommand.Return, command, by),
            MavCmd.NavLand => Make(OperatorCommand.Land, command, by),
            MavCmd.MissionStart => Make(OperatorCommand.Continue, command, by),
            MavCmd.DoChangeSpeed => new OperatorRequest(OperatorCommand.ChangeSpeed, by, ReasonOf(command))
            {
                SpeedMetresPerSecond = command.Param2,
            },
            MavCmd.DoSetRoiLocation => OfPlace(command, by),
            MavCmd.User1 => OfAction(command, by),
            _ => null,
        };
        if (request is null && !IsKnown(command.Command))
            refusal = MavResult.Unsupported;
        return request is not null;
    }

    private static bool IsKnown(MavCmd command)
        => command is MavCmd.DoPauseContinue or MavCmd.DoSetRoiLocation or MavCmd.User1;

    private static string ReasonOf(in MavlinkCommand command) => MavlinkNames.Of(command.Command);

    private static OperatorRequest Make(OperatorCommand what, in MavlinkCommand command, string by)
        => new(what, by, ReasonOf(command));

    // COMMAND_INT has the place in 1e-7 degrees, COMMAND_LONG in degrees. Comparisons with NaN are false.
    private static OperatorRequest? OfPlace(in MavlinkCommand command, string by)
    {
        bool isInt = command.Forms == MavlinkCommandForms.IntOnly;
        double latitude = isInt ? command.X * DegreesPerUnit : command.Param5;
        double longitude = isInt ? command.Y * DegreesPerUnit : command.Param6;
        return latitude >= -90 && latitude <= 90 && longitude >= -180 && longitude <= 180
            ? new OperatorRequest(OperatorCommand.RevisitPlace, by, ReasonOf(command))
            {
                Place = GeodeticPosition.FromDegrees(latitude, longitude, 0),
            }
            : null;
    }

    private static OperatorRequest? OfAction(in MavlinkCommand command, string by)
    {
        OperatorCommand? what = command.Param1 switch
        {
            1 => OperatorCommand.SkipLane,
            2 => OperatorCommand.Revisit,
            3 => OperatorCommand.Confirm,
            4 => OperatorCommand.Reject,
            _ => null,
        };
        bool isTrack = command.Param2 >= 1 && command.Param2 <= 1_000_000
            && command.Param2.Equals((int)command.Param2);

        // Each vehicle numbers its tracks itself.
        isTrack &= command.Target.SystemId != 0;
        return what is { } action && (isTrack || action == OperatorCommand.SkipLane)
            ? new OperatorRequest(action, by, ReasonOf(command)) { TrackId = isTrack ? (int)command.Param2 : 0 }
            : null;
    }
}
