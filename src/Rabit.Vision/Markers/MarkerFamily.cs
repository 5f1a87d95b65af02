namespace Rabit.Vision;

/// <summary>A family of square markers, as printed.</summary>
public enum MarkerFamily
{
    /// <summary>ArUco's DICT_4X4_50: 4 x 4 cells in a black ring, ids 0 to 49.</summary>
    ArUco4x4,

    /// <summary>AprilTag's 36h11: 6 x 6 cells in a black ring, ids 0 to 586.</summary>
    AprilTag36h11,
}
