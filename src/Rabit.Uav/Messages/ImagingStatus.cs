using System;

namespace Rabit.Uav.Messages;

/// <summary>What Image Processing did so far, for each picture that was searched, and at least once a second. A plain value; counts are since the start.</summary>
public struct ImagingStatus
{
    /// <summary>Whether there is a camera at all.</summary>
    public bool HasCamera { get; set; }

    /// <summary>The order it works by.</summary>
    public ImagingMode Mode { get; set; }

    /// <summary>When the last picture came, by the clock of the run; null before the first.</summary>
    public TimeSpan? LastFrameTime { get; set; }

    /// <summary>Pictures that came.</summary>
    public long Frames { get; set; }

    /// <summary>Pictures that were searched.</summary>
    public long Looks { get; set; }

    /// <summary>The last picture that was searched, and the ground that it shows; empty before the first.</summary>
    public CameraObservation LastObservation { get; set; }

    /// <summary>Pictures that were lost before they came to us, or had no room.</summary>
    public long FramesDropped { get; set; }

    /// <summary>Pictures that could not be located: no pose for their time, or they do not show the ground.</summary>
    public long FramesRefused { get; set; }

    /// <summary>Why the last one was refused; null where none was.</summary>
    public string? LastRefusal { get; set; }

    /// <summary>Reports of targets that went out.</summary>
    public long Reports { get; set; }

    /// <summary>Targets that were seen but not reported: too many in one picture, or no room in a queue.</summary>
    public long ReportsDropped { get; set; }

    /// <summary>Whether the camera gives no more pictures, because it has no more or failed.</summary>
    public bool HasEnded { get; set; }

    /// <summary>What ended the camera, where it failed.</summary>
    public string? Fault { get; set; }
}
