namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>What a <see cref="PoseHistory"/> knows of a moment.</summary>
internal enum PoseLookup
{
    /// <summary>It lies between two samples of each kind.</summary>
    Known,

    /// <summary>The samples do not reach so far yet.</summary>
    NotYet,

    /// <summary>It lies before all that is kept.</summary>
    TooOld,

    /// <summary>The samples around it are too far apart.</summary>
    Gap,

    /// <summary>It was extrapolated from the newest samples.</summary>
    Extrapolated,
}
