namespace Rabit.Uav.CameraGeometry;

/// <summary>Why the place of a pixel is not told.</summary>
public enum GeolocationError
{
    /// <summary>It is told.</summary>
    None,

    /// <summary>The pixel is not in the picture.</summary>
    OutsidePicture,

    /// <summary>The formula of the lens cannot be undone there.</summary>
    LensCannotBeUndone,

    /// <summary>The line of sight points above the horizon, or too little below it.</summary>
    NearHorizon,

    /// <summary>The camera is below the ground.</summary>
    CameraBelowGround,

    /// <summary>The line of sight leaves the grid of heights, still above it.</summary>
    LeavesTerrain,

    /// <summary>The line of sight may meet the ground where the grid of heights has none.</summary>
    NoTerrainData,

    /// <summary>No pose reaches the time of the picture.</summary>
    NoPose,

    /// <summary>The picture is older than all poses.</summary>
    PoseTooOld,

    /// <summary>The poses around the time of the picture are too far apart.</summary>
    PoseGap,
}
