using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// How a camera sits on the vehicle: misalignment and lever arms. Its gimbal turns by yaw, then pitch, then roll, from
/// where the optical axis points forward: pitch -90 degrees looks straight down with the top of the picture forward. A
/// camera without a gimbal is one whose angles never change, or has a <see cref="FixedBodyFromCamera"/>. Immutable.
/// </summary>
/// <remarks>
/// North-east-down from gimbal = base * Rz(misalignment yaw) Ry(misalignment pitch) Rx(misalignment roll) * Rz(gimbal
/// yaw) Ry(gimbal pitch) Rx(gimbal roll), where the base is the attitude of the body, its heading alone or north, as
/// <see cref="GimbalAttitude.Frame"/> says. Axes of the gimbal: x along the optical axis, y to the right in the
/// picture, z down in the picture.
/// </remarks>
public sealed class CameraMount
{
    /// <summary>
    /// What the angles that the gimbal is pointed by are against, for as long as it does not report its attitude.
    /// </summary>
    /// <value>
    /// The default is <see cref="GimbalFrame.Body"/>. A stabilised gimbal whose angles are taken to be against the body
    /// gives places that are wrong by the vehicle's tilt: 17 m for 8 degrees at a height of 100 m, looking 60 degrees
    /// down.
    /// </value>
    public GimbalFrame GimbalFrame { get; init; }

    /// <summary>Misalignment about forward.</summary>
    public Angle MisalignmentRoll { get; init; }

    /// <summary>Misalignment about right.</summary>
    public Angle MisalignmentPitch { get; init; }

    /// <summary>Misalignment about down.</summary>
    public Angle MisalignmentYaw { get; init; }

    /// <summary>Where the gimbal's centre is, from the point whose position the autopilot reports, metres.</summary>
    public BodyVector GimbalLeverArmMetres { get; init; }

    /// <summary>
    /// Where the camera is from the gimbal's centre, metres, in the axes of the gimbal: forward is along the optical
    /// axis.
    /// </summary>
    public BodyVector CameraLeverArmMetres { get; init; }

    /// <summary>
    /// For a camera without a gimbal: from its axes (x right, y down, z along the optical axis) to the body's. The
    /// misalignment comes on top.
    /// </summary>
    /// <value>Null, the default, where the angles of the gimbal say it. See <see cref="Rotation.FromMatrix"/>.</value>
    public Rotation? FixedBodyFromCamera { get; init; }

    // x_gimbal = z_camera, y_gimbal = x_camera, z_gimbal = y_camera: a turn by 120 degrees about (1, 1, 1).
    private static Rotation GimbalFromCamera => Rotation.FromQuaternion(1, 1, 1, 1);

    /// <summary>Where the camera is and how it stands in the body frame.</summary>
    /// <param name="gimbalPitch">
    /// Against the body, up positive. Not used with <see cref="FixedBodyFromCamera"/>.
    /// </param>
    /// <param name="gimbalYaw">
    /// Against the body, right positive. Not used with <see cref="FixedBodyFromCamera"/>.
    /// </param>
    public CameraExtrinsics At(Angle gimbalPitch, Angle gimbalYaw)
        => At(GimbalAttitude.AgainstBody(gimbalPitch, gimbalYaw), Rotation.Identity);

    /// <summary>Where the camera is and how it stands in the body frame.</summary>
    /// <param name="gimbal">Not used with <see cref="FixedBodyFromCamera"/>.</param>
    /// <param name="attitude">Of the body: north-east-down from body. Not used where the gimbal is against it.</param>
    public CameraExtrinsics At(GimbalAttitude gimbal, Rotation attitude) => At(gimbal, attitude, default);

    /// <summary>As the other, with an error of the misalignment: what would be if it were so.</summary>
    internal CameraExtrinsics At(GimbalAttitude gimbal, Rotation attitude, EulerAngles misalignmentError)
    {
        Rotation turn = FixedBodyFromCamera is { } fixedCamera
            ? fixedCamera * GimbalFromCamera.Inverse
            : Rotation.FromEuler(gimbal.Angles);
        Rotation bodyFromGimbal = Rotation.FromEuler(new EulerAngles(
            MisalignmentRoll + misalignmentError.Roll, MisalignmentPitch + misalignmentError.Pitch,
            MisalignmentYaw + misalignmentError.Yaw)) * turn;
        if (FixedBodyFromCamera is null && gimbal.Frame != GimbalFrame.Body)
            bodyFromGimbal = attitude.Inverse * BaseOf(gimbal.Frame, attitude) * bodyFromGimbal;
        (double x, double y, double z) = bodyFromGimbal.Apply(
            CameraLeverArmMetres.Forward, CameraLeverArmMetres.Right, CameraLeverArmMetres.Down);
        return new CameraExtrinsics(
            bodyFromGimbal * GimbalFromCamera,
            GimbalLeverArmMetres + new BodyVector(x, y, z));
    }

    /// <summary>What is wrong with it, one line each.</summary>
    internal IEnumerable<string> FindFaults()
    {
        if (!(MisalignmentRoll.IsFinite && MisalignmentPitch.IsFinite && MisalignmentYaw.IsFinite))
            yield return "the misalignment of the camera mount is not a number";
        if (!GimbalLeverArmMetres.IsFinite)
            yield return $"{nameof(GimbalLeverArmMetres)} is not a number";
        if (!CameraLeverArmMetres.IsFinite)
            yield return $"{nameof(CameraLeverArmMetres)} is not a number";
        if (GimbalFrame is not (GimbalFrame.Body or GimbalFrame.Heading or GimbalFrame.North))
            yield return $"{nameof(GimbalFrame)} of the camera mount is {GimbalFrame}";
        if (FixedBodyFromCamera is { IsValid: false })
            yield return $"{nameof(FixedBodyFromCamera)} is no rotation";
    }

    // North-east-down from what the angles are against.
    private static Rotation BaseOf(GimbalFrame frame, Rotation attitude)
        => frame == GimbalFrame.Heading
            ? Rotation.FromEuler(new EulerAngles(Angle.Zero, Angle.Zero, attitude.ToEuler().Yaw))
            : Rotation.Identity;
}
