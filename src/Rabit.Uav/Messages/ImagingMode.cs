namespace Rabit.Uav.Messages;

/// <summary>What Image Processing does with pictures.</summary>
public enum ImagingMode
{
    /// <summary>Give them back unsearched.</summary>
    Off,

    /// <summary>Search them for targets, and report which ground was seen.</summary>
    Search,

    /// <summary>
    /// The same while one target is followed. Pictures that cannot be used are no reason to hold or to return then: the
    /// target would be gone. Without usable ones it is lost after a while, and the search goes on.
    /// </summary>
    Follow,
}
