using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Geometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What one make of autopilot wants to hear, and what it does by itself. Stateless.</summary>
internal abstract class VehicleProfile
{
    private protected const double DegreesPerRadian = 180 / Math.PI;

    // 1: the custom mode is the one that counts (MAV_MODE_FLAG_CUSTOM_MODE_ENABLED).
    private protected const float ByCustomMode = 1;

    private const double DegE7PerRadian = DegreesPerRadian * 1e7;

    // What both makes brake with unless told otherwise: ArduCopter WPNAV_ACCEL 2.5 m/s2, PX4 MPC_ACC_HOR 3 m/s2; the weaker overshoots less.
    private const double BrakingMetresPerSecond2 = 2.5;

    /// <summary>The mode in which it takes targets from us.</summary>
    public abstract uint CommandedMode { get; }

    public abstract uint ReturnMode { get; }

    public abstract uint LandMode { get; }

    /// <summary>The profile of a vehicle; null where it is not commanded, and why.</summary>
    public static VehicleProfile? For(in VehicleState vehicle, out string? refusal)
    {
        refusal = null;
        if (!ArdupilotModes.IsCopter(vehicle.VehicleType))
        {
            refusal = $"a {vehicle.VehicleType} is not commanded, only multirotors and helicopters are";
            return null;
        }

        switch (vehicle.Autopilot)
        {
            case MavAutopilot.Ardupilotmega:
                return CopterProfile.Instance;
            case MavAutopilot.Px4:
                return Px4Profile.Instance;
            default:
                refusal = $"autopilot {vehicle.Autopilot} is not commanded, only ArduPilot and PX4 are";
                return null;
        }
    }

    /// <summary>Whether the autopilot goes from a mode that we asked for to another by itself, as part of it.</summary>
    public abstract bool FollowsByItself(uint mode, uint next);

    /// <summary>The number of a mode; null where it has none of that name.</summary>
    public abstract uint? ModeOf(MavType vehicle, string name);

    public abstract CommandStep SetMode(uint mode);

    /// <summary>The steps of a command whose figures are sound.</summary>
    /// <param name="command">The command.</param>
    /// <param name="context">What is known of the vehicle.</param>
    /// <param name="steps">Where they are added.</param>
    /// <returns>Why it is not possible; null where it is.</returns>
    public abstract string? Plan(in VehicleCommand command, in CommandContext context, List<CommandStep> steps);

    private protected static CommandStep Long(MavCmd command, double param1 = 0, double param2 = 0, double param3 = 0) => new()
    {
        Request = new MavlinkRequest { Command = command, Param1 = (float)param1, Param2 = (float)param2, Param3 = (float)param3 },
    };

    private protected static CommandStep Arm(bool arms) => Long(MavCmd.ComponentArmDisarm, arms ? 1 : 0);

    /// <summary>Without flags the angles are against the body; rates are left to the gimbal (MAV_CMD_DO_GIMBAL_MANAGER_PITCHYAW).</summary>
    private protected static CommandStep PointCamera(in VehicleCommand command) => new()
    {
        Request = new MavlinkRequest
        {
            Command = MavCmd.DoGimbalManagerPitchyaw,
            Param1 = (float)(command.CameraPitchRadians * DegreesPerRadian),
            Param2 = (float)(command.CameraYawRadians * DegreesPerRadian),
            Param3 = float.NaN,
            Param4 = float.NaN,
        },
    };

    private protected static int DegE7(double radians) => (int)Math.Round(radians * DegE7PerRadian);

    /// <summary>Where the vehicle comes to rest if it brakes now, at the height that it has.</summary>
    private protected static GeodeticPosition StoppingPoint(in VehicleState vehicle)
    {
        NedVector v = vehicle.VelocityNed;
        double speed = Math.Sqrt((v.North * v.North) + (v.East * v.East));
        double seconds = speed / (2 * BrakingMetresPerSecond2);
        return LocalNedFrame.IgnoringGeoid(vehicle.Position).ToGeodetic(new NedVector(v.North * seconds, v.East * seconds, 0));
    }

    /// <summary>The steps of a command for a mode by name.</summary>
    private protected string? PlanMode(string name, in VehicleState vehicle, List<CommandStep> steps)
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
