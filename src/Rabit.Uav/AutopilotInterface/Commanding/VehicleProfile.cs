using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What commands one make of autopilot takes, and what it does by itself. Stateless.</summary>
internal abstract class VehicleProfile
{
    // 1: the custom mode is the one that counts (MAV_MODE_FLAG_CUSTOM_MODE_ENABLED).
    private const float ByCustomMode = 1;

    private const double DegE7PerRadian = 1e7 / Angle.RadiansPerDegree;

    // What both makes brake with by default: ArduCopter WPNAV_ACCEL 2.5 m/s2, PX4 MPC_ACC_HOR 3 m/s2; the weaker
    // overshoots less.
    private const double BrakingMetresPerSecond2 = 2.5;

    /// <summary>The mode in which it takes targets from us.</summary>
    public abstract uint CommandedMode { get; }

    public abstract uint ReturnMode { get; }

    public abstract uint LandMode { get; }

    /// <summary>
    /// Whether it lets a gimbal be pointed only by the one that it was given to (MAV_CMD_DO_GIMBAL_MANAGER_CONFIGURE).
    /// </summary>
    private protected virtual bool GivesGimbalsToOne => false;

    /// <summary>The profile of a vehicle; null where it is not commanded, and why.</summary>
    public static VehicleProfile? For(in VehicleState vehicle, bool mayCommandFixedWing, out string? refusal)
    {
        bool isFixedWing = FixedWings.IsFixedWing(vehicle.VehicleType);
        refusal = isFixedWing
            ? mayCommandFixedWing ? null : FixedWingProfile.NotAllowed
            : ArdupilotModes.IsCopter(vehicle.VehicleType)
                ? null
                : $"a {vehicle.VehicleType} is not commanded, only multirotors and helicopters are";
        if (refusal is not null)
            return null;
        switch (vehicle.Autopilot)
        {
            case MavAutopilot.Ardupilotmega:
                return isFixedWing ? ArdupilotPlaneProfile.Instance : CopterProfile.Instance;
            case MavAutopilot.Px4:
                return isFixedWing ? Px4PlaneProfile.Instance : Px4Profile.Instance;
            default:
                refusal = $"autopilot {vehicle.Autopilot} is not commanded, only ArduPilot and PX4 are";
                return null;
        }
    }

    /// <summary>Whether the autopilot goes from a mode of ours to another by itself, as part of it.</summary>
    /// <param name="mode">Our mode.</param>
    /// <param name="vehicle">The state with the other mode.</param>
    /// <param name="takeOffHeightMetres">The height of our take-off above home.</param>
    public abstract bool FollowsByItself(uint mode, in VehicleState vehicle, double takeOffHeightMetres);

    /// <summary>
    /// Whether it may be so, and the next reports of the position decide: a mode that it takes at a height of its own.
    /// </summary>
    /// <param name="mode">Our mode.</param>
    /// <param name="vehicle">The state with the other mode.</param>
    /// <param name="takeOffHeightMetres">The height of our take-off above home.</param>
    public virtual bool MayFollowByItself(uint mode, in VehicleState vehicle, double takeOffHeightMetres) => false;

    /// <summary>The number of a mode; null where it has none of that name.</summary>
    public abstract uint? ModeOf(MavType vehicle, string name);

    /// <summary>The steps of a command whose figures are valid.</summary>
    /// <param name="command">The command.</param>
    /// <param name="context">What is known of the vehicle.</param>
    /// <param name="steps">Where they are added.</param>
    /// <returns>Why it is not possible; null where it is.</returns>
    public virtual string? Plan(in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        switch (command.Kind)
        {
            case VehicleCommandKind.Arm:
                steps.Add(SetMode(CommandedMode));
                steps.Add(Arm(true));
                return null;
            case VehicleCommandKind.Disarm:
                steps.Add(Arm(false));
                return null;
            case VehicleCommandKind.SetMode:
                return PlanMode(command.Mode!, context.Vehicle, steps);
            case VehicleCommandKind.Return:
                steps.Add(SetMode(ReturnMode));
                return null;
            case VehicleCommandKind.Land:
                steps.Add(SetMode(LandMode));
                return null;
            case VehicleCommandKind.PointCamera:
                if (GivesGimbalsToOne)
                    steps.Add(Long(MavCmd.DoGimbalManagerConfigure, context.Own.SystemId, context.Own.ComponentId));
                steps.Add(PointCamera(command));
                return null;
            default:
                return PlanFlight(command, context, steps);
        }
    }

    /// <summary>The steps of what moves the vehicle: taking off, going to a place, holding, velocities.</summary>
    /// <returns>Why it is not possible; null where it is.</returns>
    private protected abstract string? PlanFlight(
        in VehicleCommand command, in CommandContext context, List<CommandStep> steps);

    /// <summary>The custom mode as the parameters 2 and 3 of MAV_CMD_DO_SET_MODE.</summary>
    private protected abstract (float Mode, float SubMode) ModeParameters(uint mode);

    private protected static CommandStep Long(MavCmd command, double param1 = 0, double param2 = 0, double param3 = 0)
        => new()
        {
            Request = new MavlinkCommand
            {
                Command = command,
                Param1 = (float)param1,
                Param2 = (float)param2,
                Param3 = (float)param3
            },
        };

    /// <summary>
    /// A place, as COMMAND_INT and nothing else: without its frame an autopilot would guess what the height counts
    /// from.
    /// </summary>
    private protected static CommandStep Reposition(
        MavFrame frame, double latitudeRadians, double longitudeRadians, double heightMetres, in VehicleCommand command,
        float flags = 0)
            => new()
            {
                Request = new MavlinkCommand
                {
                    Command = MavCmd.DoReposition,
                    Forms = MavlinkCommandForms.IntOnly,
                    HasLocation = true,
                    Frame = frame,
                    Param1 = double.IsNaN(command.SpeedMetresPerSecond) ? -1 : (float)command.SpeedMetresPerSecond,
                    Param2 = flags,
                    Param4 = (float)command.Yaw.Radians,
                    X = DegE7(latitudeRadians),
                    Y = DegE7(longitudeRadians),
                    Z = (float)heightMetres,
                },
            };

    // Where the speed and the heading are left to the vehicle.
    private protected static VehicleCommand Plain { get; } = new()
    {
        SpeedMetresPerSecond = double.NaN,
        Yaw = Angle.NaN
    };

    private static CommandStep Arm(bool arms)
    {
        CommandStep step = Long(MavCmd.ComponentArmDisarm, arms ? 1 : 0);
        step.NeedsReport = arms;
        return step;
    }

    /// <summary>The step to a mode.</summary>
    private protected CommandStep SetMode(uint mode)
    {
        (float main, float sub) = ModeParameters(mode);
        CommandStep step = Long(MavCmd.DoSetMode, ByCustomMode, main, sub);
        step.Mode = mode;
        step.IsModeAwaited = step.NeedsReport = true;
        return step;
    }

    /// <summary>
    /// Without flags the angles are against the body; a locked axis holds the horizon, or north. Rates are left to the
    /// gimbal (MAV_CMD_DO_GIMBAL_MANAGER_PITCHYAW).
    /// </summary>
    private static CommandStep PointCamera(in VehicleCommand command) => new()
    {
        Request = new MavlinkCommand
        {
            Command = MavCmd.DoGimbalManagerPitchyaw,
            Param1 = (float)command.CameraPitch.Degrees,
            Param2 = (float)command.CameraYaw.Degrees,
            Param3 = float.NaN,
            Param4 = float.NaN,
            Param5 = (float)(uint)FlagsOf(command.GimbalFrame),
        },
    };

    private static GimbalManagerFlags FlagsOf(GimbalFrame frame)
    {
        const GimbalManagerFlags Horizon = GimbalManagerFlags.RollLock | GimbalManagerFlags.PitchLock;
        return frame switch
        {
            GimbalFrame.Heading => Horizon | GimbalManagerFlags.YawInVehicleFrame,
            GimbalFrame.North => Horizon | GimbalManagerFlags.YawLock | GimbalManagerFlags.YawInEarthFrame,
            _ => 0,
        };
    }

    private static int DegE7(double radians) => (int)Math.Round(radians * DegE7PerRadian);

    /// <summary>Where the vehicle comes to rest if it brakes now, at the height that it has.</summary>
    private protected static GeodeticPosition StoppingPoint(in VehicleState vehicle)
    {
        NedVector v = vehicle.VelocityNed;
        double speed = Math.Sqrt((v.North * v.North) + (v.East * v.East));
        double seconds = speed / (2 * BrakingMetresPerSecond2);
        return LocalNedFrame.IgnoringGeoid(vehicle.Position)
            .ToGeodetic(new NedPosition(v.North * seconds, v.East * seconds, 0));
    }

    /// <summary>The steps of a command for a mode by name.</summary>
    private string? PlanMode(string name, in VehicleState vehicle, List<CommandStep> steps)
    {
        if (ModeOf(vehicle.VehicleType, name) is not { } mode)
            return $"{vehicle.Autopilot} has no mode '{name}' for a {vehicle.VehicleType}";
        steps.Add(SetMode(mode));
        return null;
    }

    /// <summary>Adds the step to the mode in which it takes targets, where it is in another one.</summary>
    private protected void EnsureCommandedMode(in VehicleState vehicle, List<CommandStep> steps)
    {
        if (vehicle.CustomMode != CommandedMode)
            steps.Add(SetMode(CommandedMode));
    }
}
