namespace Rabit.Uav.Messages;

/// <summary>
/// Whether a picture can be searched for targets, and if not, why: image quality assessment, and what else makes a
/// picture worth nothing. Where several hold it is the first of this order that is found.
/// </summary>
public enum PictureQuality
{
    /// <summary>It can be searched.</summary>
    Usable,

    /// <summary>Its number is that of the picture before it: the camera or its driver does not count.</summary>
    RepeatedNumber,

    /// <summary>There is no pose for its time: no attitude or position arrives, or a clock is wrong.</summary>
    NoPose,

    /// <summary>Less than three tenths of it show the ground, near enough.</summary>
    NotGround,

    /// <summary>The detector failed, or the picture is not as the camera is described.</summary>
    NotSearched,

    /// <summary>
    /// Its pixels are too large on the ground for the smallest class that is searched for, in more than seven tenths of
    /// it.
    /// </summary>
    TooCoarse,

    /// <summary>It is black: a lens cap, or no light.</summary>
    Black,

    /// <summary>It is white: overexposed.</summary>
    White,

    /// <summary>A large part of it is at the upper end of the sensor's range.</summary>
    Saturated,

    /// <summary>It is of one colour, neither black nor white: nothing but noise.</summary>
    Uniform,

    /// <summary>It is the same as an earlier one, or nearly, although the camera has moved on.</summary>
    Frozen,

    /// <summary>A large part of it shows nothing but noise: something is before the lens.</summary>
    Covered,

    /// <summary>Details are missing in all directions.</summary>
    Defocused,

    /// <summary>
    /// Details are missing in one direction, or what moves past during the exposure is more than the smallest class
    /// allows.
    /// </summary>
    MotionBlurred,
}
