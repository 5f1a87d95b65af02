using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Json;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Reads the mount of camera.json: a fixed camera by its rotation, or one on a gimbal.</summary>
internal static class CameraMountDescription
{
    public const string BodyFromCamera = "bodyFromCamera";
    public const string LeverArm = "leverArmBodyMetres";
    private const string Gimbal = "gimbal";
    private const string CameraLeverArm = "leverArmGimbalMetres";
    private const string Frame = "frame";
    private const string Roll = "misalignmentRollDegrees";
    private const string Pitch = "misalignmentPitchDegrees";
    private const string Yaw = "misalignmentYawDegrees";

    // What was in the mount itself in an older form of the file, and is in its gimbal now.
    private static readonly (string Old, string New)[] OldOfGimbal =
        [("roll_deg", Roll), ("pitch_deg", Pitch), ("yaw_deg", Yaw), ("lever_arm_gimbal_m", CameraLeverArm)];

    /// <param name="mount">The object of the mount.</param>
    /// <param name="faults">
    /// Those that <paramref name="mount"/> adds to; where there are any, what is returned is of no use.
    /// </param>
    public static CameraMount Read(JsonFields mount, List<string> faults)
    {
        mount.Renamed(("R_body_from_cam", BodyFromCamera), ("lever_arm_body_m", LeverArm));
        bool isOldGimbal = OldOfGimbal.Any(n => mount.Has(n.Old));
        mount.Renamed([.. OldOfGimbal.Select(n => (n.Old, $"{Gimbal}.{n.New}"))]);
        double[] arm = mount.RequiredNumbers(LeverArm, 3);
        var position = new BodyVector(arm[0], arm[1], arm[2]);
        CameraMount read = mount.Has(Gimbal) || isOldGimbal
            ? OnGimbal(mount, position, faults)
            : Fixed(mount, position, faults);
        mount.RefuseOthers();
        return read;
    }

    private static CameraMount OnGimbal(JsonFields mount, BodyVector position, List<string> faults)
    {
        if (mount.Has(BodyFromCamera))
            faults.Add(
                $"camera.mount has both {BodyFromCamera}, of a fixed camera, and {Gimbal}; it must have one of them");
        JsonFields gimbal = mount.Object(Gimbal);
        gimbal.Renamed(OldOfGimbal);
        double[] arm = gimbal.Has(CameraLeverArm) ? gimbal.RequiredNumbers(CameraLeverArm, 3) : new double[3];
        var read = new CameraMount
        {
            GimbalFrame = gimbal.Choice(Frame, "body", "heading", "north") switch
            {
                "heading" => GimbalFrame.Heading,
                "north" => GimbalFrame.North,
                _ => GimbalFrame.Body,
            },
            GimbalLeverArmMetres = position,
            CameraLeverArmMetres = new BodyVector(arm[0], arm[1], arm[2]),
            MisalignmentRoll = Angle.FromDegrees(gimbal.Number(Roll) ?? 0),
            MisalignmentPitch = Angle.FromDegrees(gimbal.Number(Pitch) ?? 0),
            MisalignmentYaw = Angle.FromDegrees(gimbal.Number(Yaw) ?? 0),
        };
        gimbal.RefuseOthers();
        return read;
    }

    private static CameraMount Fixed(JsonFields mount, BodyVector position, List<string> faults)
    {
        int before = faults.Count;
        double[] matrix = mount.RequiredMatrix(BodyFromCamera);
        if (!TryRotation(matrix, out Rotation rotation, out string reason) && faults.Count == before
            && mount.Has(BodyFromCamera))
            faults.Add("camera.mount." + BodyFromCamera + ": " + reason);
        return new CameraMount { FixedBodyFromCamera = rotation, GimbalLeverArmMetres = position };
    }

    private static bool TryRotation(double[] matrix, out Rotation rotation, out string reason)
    {
        (rotation, reason) = (Rotation.Identity, string.Empty);
        try
        {
            rotation = Rotation.FromMatrix(matrix);
            return true;
        }
        catch (ArgumentException e)
        {
            // What is wrong, without the name of the parameter that a runtime puts on another line.
            reason = e.Message.Split('\r', '\n')[0];
            int at = reason.IndexOf(" (Parameter", StringComparison.Ordinal);
            reason = at < 0 ? reason : reason.Substring(0, at);
            return false;
        }
    }
}
