using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>A MAVLink command in the form in which it is sent: COMMAND_LONG, or COMMAND_INT where it has a place. A plain value.</summary>
internal struct MavlinkRequest
{
    public MavCmd Command { get; set; }

    /// <summary>The frame of the place, for COMMAND_INT; null for COMMAND_LONG.</summary>
    public MavFrame? Frame { get; set; }

    public float Param1 { get; set; }

    public float Param2 { get; set; }

    public float Param3 { get; set; }

    public float Param4 { get; set; }

    /// <summary>Of COMMAND_LONG.</summary>
    public float Param5 { get; set; }

    /// <summary>Of COMMAND_LONG.</summary>
    public float Param6 { get; set; }

    /// <summary>Of COMMAND_LONG; of COMMAND_INT the altitude, metres.</summary>
    public float Param7 { get; set; }

    /// <summary>Latitude of COMMAND_INT, 1e-7 degrees.</summary>
    public int LatitudeDegE7 { get; set; }

    /// <summary>Longitude of COMMAND_INT, 1e-7 degrees.</summary>
    public int LongitudeDegE7 { get; set; }

    /// <summary>The frame to send.</summary>
    /// <param name="from">Who we are.</param>
    /// <param name="to">The autopilot.</param>
    /// <param name="confirmation">How often it was sent before, of COMMAND_LONG.</param>
    public readonly MavlinkFrame ToFrame(in OwnAddress from, in VehicleState to, byte confirmation) => Frame is { } frame
        ? MavlinkFrame.Create(ToInt(to, frame), from.SystemId, from.ComponentId, sequence: 0)
        : MavlinkFrame.Create(ToLong(to, confirmation), from.SystemId, from.ComponentId, sequence: 0);

    private readonly CommandLong ToLong(in VehicleState to, byte confirmation) => new()
    {
        TargetSystem = to.SystemId,
        TargetComponent = to.ComponentId,
        Command = Command,
        Confirmation = confirmation,
        Param1 = Param1,
        Param2 = Param2,
        Param3 = Param3,
        Param4 = Param4,
        Param5 = Param5,
        Param6 = Param6,
        Param7 = Param7,
    };

    private readonly CommandInt ToInt(in VehicleState to, MavFrame frame) => new()
    {
        TargetSystem = to.SystemId,
        TargetComponent = to.ComponentId,
        Frame = frame,
        Command = Command,
        Param1 = Param1,
        Param2 = Param2,
        Param3 = Param3,
        Param4 = Param4,
        X = LatitudeDegE7,
        Y = LongitudeDegE7,
        Z = Param7,
    };
}
