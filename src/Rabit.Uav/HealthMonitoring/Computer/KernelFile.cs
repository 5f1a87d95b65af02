using System;
using System.IO;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// A small file of the kernel (/proc, /sys) that is read again and again: it stays open, and comes into one buffer, so
/// that a read allocates nothing. A file that is not there is an empty one. One thread.
/// </summary>
internal sealed class KernelFile(string path) : IDisposable
{
    // After a failure it is left alone for so many reads: a failure costs an exception.
    private const int ReadsLeftOut = 60;

    // The lines of interest are the first ones of each file.
    private readonly byte[] _buffer = new byte[4096];
    private FileStream? _file;
    private int _leftOut;

    /// <summary>Its text, up to the next call; empty where it cannot be read.</summary>
    public ReadOnlySpan<byte> Read()
    {
        if (_leftOut > 0)
        {
            _leftOut--;
            return default;
        }

        // No exception where a computer has no such file.
        if (_file is null && !File.Exists(path))
        {
            _leftOut = ReadsLeftOut;
            return default;
        }

        try
        {
            // Without a buffer of its own, which would keep what it was.
            _file ??= new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, bufferSize: 1);
            _file.Position = 0;
            return new ReadOnlySpan<byte>(_buffer, 0, _file.Read(_buffer, 0, _buffer.Length));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            Dispose();
            _leftOut = ReadsLeftOut;
            return default;
        }
    }

    public void Dispose()
    {
        _file?.Dispose();
        _file = null;
    }
}
