using System;

namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>
/// The calls of the operating system that a video device needs. What fails returns the negative error number.
/// </summary>
internal interface IVideoSystem
{
    /// <summary>4 or 8: the layout of the kernel's structures follows from it.</summary>
    int PointerBytes { get; }

    /// <summary>Opens a device for reading, writing and control, without blocking.</summary>
    /// <returns>Its descriptor.</returns>
    int Open(string path);

    /// <summary>ioctl.</summary>
    int Control(int descriptor, uint request, byte[] argument);

    /// <summary>Waits until there is something to fetch, or an error that fetching returns.</summary>
    /// <returns>1, or 0 after the time.</returns>
    int Wait(int descriptor, int milliseconds);

    /// <summary>Maps a buffer of the device into memory.</summary>
    /// <returns>Zero where that fails.</returns>
    IntPtr Map(int descriptor, uint offset, int length);

    void Unmap(IntPtr address, int length);

    void Close(int descriptor);

    /// <summary>The clock that drivers stamp their buffers with, CLOCK_MONOTONIC.</summary>
    long MonotonicMicroseconds();
}
