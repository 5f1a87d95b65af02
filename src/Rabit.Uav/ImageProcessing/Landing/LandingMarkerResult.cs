namespace Rabit.Uav.ImageProcessing;

/// <summary>What a <see cref="LandingMarkerFinder"/> made of a picture.</summary>
internal enum LandingMarkerResult
{
    /// <summary>The marker is not in it.</summary>
    None,

    /// <summary>It is in it.</summary>
    Found,

    /// <summary>There are two of it: which one to land on cannot be known.</summary>
    SeenTwice,

    /// <summary>Its corners are none of a square in front of the camera.</summary>
    NotASquare,

    /// <summary>The picture is not of the camera's size, or has no buffer.</summary>
    NoPicture,
}
