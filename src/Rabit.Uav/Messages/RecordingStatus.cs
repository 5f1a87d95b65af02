namespace Rabit.Uav.Messages;

/// <summary>
/// What Communications reports of the recording of the links, at least once a second. A plain value; counts are since
/// the start.
/// </summary>
public struct RecordingStatus
{
    /// <summary>The file that is written, with its folder; null before the first frame.</summary>
    public string? File { get; set; }

    /// <summary>How many files of this run there are.</summary>
    public int Files { get; set; }

    /// <summary>How many older files of this run were deleted, to keep to the limit.</summary>
    public int FilesDeleted { get; set; }

    /// <summary>Frames in the files.</summary>
    public long Frames { get; set; }

    /// <summary>Bytes in the files.</summary>
    public long Bytes { get; set; }

    /// <summary>Frames that are not in the files, since the disk was too slow: there was no room to wait.</summary>
    public long FramesDropped { get; set; }

    /// <summary>Frames that are not in the files, since they could not be written: <see cref="Fault"/>.</summary>
    public long FramesLost { get; set; }

    /// <summary>Why frames cannot be written at present; null while they can.</summary>
    public string? Fault { get; set; }
}
