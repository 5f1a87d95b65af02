namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>
/// Numbers and places of linux/videodev2.h. Where a structure has pointers or times in it, its size, the places behind
/// them and the number of its call differ between processes of 32 and of 64 bits.
/// </summary>
internal sealed class V4l2Layout
{
    public const uint QueryCapabilities = 0x8068_5600;
    public const uint RequestBuffers = 0xC014_5608;
    public const uint StreamOn = 0x4004_5612;
    public const uint StreamOff = 0x4004_5613;
    public const uint SetParameters = 0xC0CC_5616;
    public const uint GetControl = 0xC008_561B;
    public const uint SetControl = 0xC008_561C;
    public const uint QueryControl = 0xC044_5624;

    public const int CapabilitiesBytes = 104;
    public const int CardAt = 16;
    public const int CardBytes = 32;
    public const int CapabilitiesAt = 84;
    public const int DeviceCapabilitiesAt = 88;
    public const uint Captures = 0x1;
    public const uint CapturesPlanes = 0x1000;
    public const uint Streams = 0x0400_0000;
    public const uint HasDeviceCapabilities = 0x8000_0000;

    public const int RequestBytes = 20;
    public const int RequestTypeAt = 4;
    public const int RequestMemoryAt = 8;

    public const int ParametersBytes = 204;
    public const int ParameterCapabilityAt = 4;
    public const int PeriodNumeratorAt = 12;
    public const int PeriodDenominatorAt = 16;
    public const uint CanSetPeriod = 0x1000;

    public const int ControlBytes = 8;
    public const int ControlValueAt = 4;
    public const int QueryControlBytes = 68;
    public const int ControlMinAt = 40;
    public const int ControlMaxAt = 44;
    public const int ControlFlagsAt = 56;
    public const uint IsDisabled = 0x1;
    public const uint IsReadOnly = 0x4;

    public const uint ExposureMode = 0x009A_0901;
    public const uint ExposureTime = 0x009A_0902;        // 100 us
    public const uint ExposureMayReduceRate = 0x009A_0903;
    public const uint Focus = 0x009A_090A;
    public const uint FocusIsAutomatic = 0x009A_090C;
    public const int ExposureManual = 1;

    public const uint Capture = 1;                       // V4L2_BUF_TYPE_VIDEO_CAPTURE
    public const uint Mapped = 1;                        // V4L2_MEMORY_MMAP
    public const uint AnyField = 0;
    public const uint Mjpeg = 0x4750_4A4D;
    public const uint Jpeg = 0x4745_504A;
    public const uint Yuyv = 0x5659_5559;
    public const uint FullRange = 1;

    public const uint FlagError = 0x40;
    public const uint FlagStampMask = 0xE000;
    public const uint FlagMonotonic = 0x2000;
    public const uint FlagStampAtMask = 0x7_0000;
    public const uint FlagStartOfExposure = 0x1_0000;

    public const int BufferTypeAt = 4;
    public const int BufferUsedAt = 8;
    public const int BufferFlagsAt = 12;

    public V4l2Layout(int pointerBytes)
    {
        bool is64 = pointerBytes == 8;
        SetFormat = is64 ? 0xC0D0_5605 : 0xC0CC_5605;
        QueryBuffer = is64 ? 0xC058_5609 : 0xC044_5609;
        Queue = is64 ? 0xC058_560F : 0xC044_560F;
        Dequeue = is64 ? 0xC058_5611 : 0xC044_5611;
        (FormatBytes, PictureAt) = is64 ? (208, 8) : (204, 4);
        (BufferBytes, StampAt, SequenceAt) = is64 ? (88, 24, 56) : (68, 20, 44);
        (MemoryAt, OffsetAt, LengthAt) = is64 ? (60, 64, 72) : (48, 52, 56);
        StampNumberBytes = pointerBytes;
    }

    public uint SetFormat { get; }

    public uint QueryBuffer { get; }

    public uint Queue { get; }

    public uint Dequeue { get; }

    public int FormatBytes { get; }

    /// <summary>
    /// Where struct v4l2_pix_format is in v4l2_format: width, height, pixel format, field, bytes of a row, bytes of the
    /// picture, 4 bytes each, and the quantization 40 bytes behind.
    /// </summary>
    public int PictureAt { get; }

    public int BufferBytes { get; }

    /// <summary>Where the time is: seconds and microseconds, of <see cref="StampNumberBytes"/> each.</summary>
    public int StampAt { get; }

    public int StampNumberBytes { get; }

    public int SequenceAt { get; }

    public int MemoryAt { get; }

    public int OffsetAt { get; }

    public int LengthAt { get; }
}
