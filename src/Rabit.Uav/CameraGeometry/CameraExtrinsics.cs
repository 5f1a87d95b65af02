using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>Where a camera is and how it stands on its vehicle at a moment. A plain value.</summary>
/// <param name="bodyFromCamera">From the camera's axes (x right, y down, z along the optical axis) to the body's.</param>
/// <param name="positionMetres">Where it is in the body frame.</param>
public readonly struct CameraExtrinsics(Rotation bodyFromCamera, BodyVector positionMetres)
{
    /// <summary>From the camera's axes (x right, y down, z along the optical axis) to the body's.</summary>
    public Rotation BodyFromCamera { get; } = bodyFromCamera;

    /// <summary>Where it is in the body frame, metres.</summary>
    public BodyVector PositionMetres { get; } = positionMetres;
}
