using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.ImageProcessing.VideoDevices;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// When the pictures of a program were taken, as it reports through a pipe of its own: the record of a picture follows
/// the picture. One thread.
/// </summary>
/// <remarks>
/// Records and pictures belong together by their order alone. A time that is not before the picture's arrival, not
/// after the one before, or older than <see cref="MaxAge"/> is none: they are out of step, or of another clock. So is
/// one of an exposure that took longer than that.
/// </remarks>
internal sealed class ProcessPictureTimes(ProcessCameraOptions options) : IDisposable
{
    public static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(5);

    // Longer than that between two clocks, they are read again. By ticks: some runtimes make whole milliseconds of a
    // number of them.
    private static readonly TimeSpan MaxBetween = TimeSpan.FromTicks(2000);
    private const int MaxReads = 5;

    private readonly LinuxVideoSystem _system = new LinuxVideoSystem();
    private readonly MetadataRecords _records = new();
    private readonly byte[] _bytes = new byte[4096];
    private MetadataPipe? _pipe;
    private long _pictures;
    private long _lastStamp;
    private int _from;
    private int _filled;

    /// <summary>Makes the pipe, for a program that is started next.</summary>
    /// <returns>Its arguments, with the path of the pipe.</returns>
    /// <exception cref="IOException">The pipe cannot be made.</exception>
    public IReadOnlyList<string> Open()
    {
        Dispose();
        _pipe = new MetadataPipe();
        _records.Clear();
        (_pictures, _lastStamp, _from, _filled) = (0, 0, 0, 0);
        string path = _pipe.Path;
        return [.. options.Arguments.Select(a => a.Replace(ProcessCameraOptions.MetadataPlace, path))];
    }

    /// <summary>A picture has come, whether it is wanted or not.</summary>
    public void Count() => _pictures++;

    /// <summary>It is not known any more how many pictures came: there are no times until the next start.</summary>
    public void Lose() => _pictures = long.MaxValue;

    /// <summary>Waits for the record of the last picture that was counted; it ends with the program.</summary>
    /// <param name="arrived">When the picture came, by the clock of the run.</param>
    /// <param name="context">Its clock.</param>
    /// <param name="start">When its exposure began, by the same clock.</param>
    /// <param name="exposure">How long it took.</param>
    /// <returns>Whether its time is known.</returns>
    /// <exception cref="IOException">They are of a format that cannot be read.</exception>
    public bool TryGet(TimeSpan arrived, ReaderContext context, out TimeSpan start, out TimeSpan exposure)
    {
        (start, exposure) = (default, options.Exposure);
        if (_pictures == long.MaxValue)
            return false;
        while (_records.Count < _pictures)
        {
            if (_from == _filled)
                (_from, _filled) = (0, _pipe!.Read(_bytes));
            if (_filled == 0)
                return false;
            while (_from < _filled && _records.Count < _pictures)
                _records.Add(_bytes[_from++]);
            if (_records.IsJson)
                throw new IOException("its metadata are JSON; it needs --metadata-format txt");
        }

        if (_records.StampNanoseconds is not { } stamp || stamp <= _lastStamp)
            return false;
        if (_records.ExposureMicroseconds is { } microseconds)
        {
            // Nothing of a record with a number that cannot be is relied on.
            if (microseconds > MaxAge.Ticks / PictureFolderWriter.TicksPerMicrosecond)
                return false;
            exposure = TimeSpan.FromTicks(microseconds * PictureFolderWriter.TicksPerMicrosecond);
        }

        (TimeSpan now, TimeSpan monotonic) = ReadClocks(context);
        TimeSpan age = monotonic - TimeSpan.FromTicks(stamp / 100);
        TimeSpan taken = now - age;
        start = taken - exposure;
        bool isKnown = age < MaxAge && taken <= arrived;
        if (isKnown)
            _lastStamp = stamp;   // one that cannot be does not rule out those after it
        return isKnown;
    }

    public void Dispose()
    {
        _pipe?.Dispose();
        _pipe = null;
    }

    private (TimeSpan Now, TimeSpan Monotonic) ReadClocks(ReaderContext context)
    {
        for (int i = 1; ; i++)
        {
            TimeSpan before = context.Now;
            long monotonic = _system.MonotonicMicroseconds();
            TimeSpan after = context.Now;
            if (after - before <= MaxBetween || i == MaxReads)
                return (after, TimeSpan.FromTicks(monotonic * PictureFolderWriter.TicksPerMicrosecond));
        }
    }
}
