namespace Rabit.Uav.CameraGeometry;

/// <summary>Why a pixel has no place on the ground.</summary>
public enum GeolocationError
{
    /// <summary>It has one.</summary>
    None,

    /// <summary>The pixel is not in the picture.</summary>
    OutsidePicture,

    /// <summary>The lens distortion cannot be undone there.</summary>
    LensCannotBeUndone,

    /// <summary>The ray points above the horizon, or too little below it.</summary>
    NearHorizon,

    /// <summary>The height of the ground, or an angle of the camera, is not a number.</summary>
    NotANumber,

    /// <summary>The camera is below the ground.</summary>
    CameraBelowGround,

    /// <summary>The ray leaves the terrain grid, still above it.</summary>
    LeavesTerrain,

    /// <summary>The ray may intersect the ground where the terrain grid has no altitude.</summary>
    NoTerrainData,

    /// <summary>No pose reaches the time of the picture.</summary>
    NoPose,

    /// <summary>The picture is older than all poses.</summary>
    PoseTooOld,

    /// <summary>The poses around the time of the picture are too far apart.</summary>
    PoseGap,
}
