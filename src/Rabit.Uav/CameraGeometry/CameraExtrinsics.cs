using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// A camera's extrinsics: where it is and how it is turned in the body frame at a moment. A plain value.
/// </summary>
/// <param name="BodyFromCamera">
/// From the camera's axes (x right, y down, z along the optical axis) to the body's.
/// </param>
/// <param name="PositionMetres">Where it is in the body frame, metres.</param>
public readonly record struct CameraExtrinsics(Rotation BodyFromCamera, BodyVector PositionMetres);
