namespace Rabit.Uav.Messages;

/// <summary>What Image Processing does with pictures.</summary>
public enum ImagingMode
{
    /// <summary>Give them back unseen.</summary>
    Off,

    /// <summary>Look for targets, and say which ground was seen.</summary>
    Search,
}
