namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>A buffer that a driver has filled. A plain value.</summary>
/// <param name="Index">Which buffer.</param>
/// <param name="Bytes">How much of it is filled.</param>
/// <param name="Flags">As the driver set them.</param>
/// <param name="StampMicroseconds">When, by the clock that the flags name.</param>
/// <param name="Sequence">Which picture; a gap is what the driver lost.</param>
internal readonly record struct V4l2Buffer(int Index, int Bytes, uint Flags, long StampMicroseconds, uint Sequence)
{
    /// <summary>Whether the picture is damaged.</summary>
    public bool IsDamaged => (Flags & V4l2Layout.FlagError) != 0;

    /// <summary>Whether the time is of the clock that only goes forward.</summary>
    public bool IsStamped => (Flags & V4l2Layout.FlagStampMask) == V4l2Layout.FlagMonotonic;

    /// <summary>Whether the time is that of the start of the exposure; else of the end of the picture.</summary>
    public bool IsStartOfExposure
        => (Flags & V4l2Layout.FlagStampAtMask) == V4l2Layout.FlagStartOfExposure;
}
