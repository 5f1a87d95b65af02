namespace Rabit.Uav.Messages;

/// <summary>What Image Processing does with pictures.</summary>
public enum ImagingMode
{
    /// <summary>Give them back unsearched.</summary>
    Off,

    /// <summary>Search them for targets, and report which ground was seen.</summary>
    Search,
}
