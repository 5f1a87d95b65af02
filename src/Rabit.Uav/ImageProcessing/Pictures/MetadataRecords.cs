using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What <c>rpicam-vid --metadata-format txt</c> writes about its pictures: lines of the form Name=Value, and an empty
/// one after each picture's. Of these, when the picture was taken. One thread; allocates nothing per picture.
/// </summary>
internal sealed class MetadataRecords
{
    private const int MaxLine = 64;   // of longer ones the rest is not of use

    private static readonly byte[] Stamp = [.. "SensorTimestamp="u8];
    private static readonly byte[] Exposure = [.. "ExposureTime="u8];

    private readonly byte[] _line = new byte[MaxLine];
    private int _length;
    private bool _isEmpty = true;
    private long? _stamp;
    private long? _exposure;

    /// <summary>Whether it is JSON, rpicam-vid's other format, of which a record ends with the next one.</summary>
    public bool IsJson { get; private set; }

    /// <summary>Records that are whole.</summary>
    public long Count { get; private set; }

    /// <summary>
    /// Of the last whole record: when the readout of the picture's first row began, nanoseconds by CLOCK_MONOTONIC;
    /// null where it does not say.
    /// </summary>
    public long? StampNanoseconds { get; private set; }

    /// <summary>Of the last whole record, null where it does not say.</summary>
    public long? ExposureMicroseconds { get; private set; }

    public void Clear()
    {
        (Count, _length, _isEmpty, IsJson) = (0, 0, true, false);
        (_stamp, _exposure, StampNanoseconds, ExposureMicroseconds) = (null, null, null, null);
    }

    /// <summary>Takes the next byte.</summary>
    public void Add(byte next)
    {
        if (next != '\n')
        {
            if (_length < MaxLine)
                _line[_length++] = next;
            return;
        }

        if (_length == 0)
            EndRecord();
        else
            EndLine();
        _length = 0;
    }

    private void EndLine()
    {
        _isEmpty = false;
        IsJson |= _line[0] is (byte)'[' or (byte)'{';
        _stamp = ValueOf(Stamp) ?? _stamp;
        _exposure = ValueOf(Exposure) ?? _exposure;
    }

    private void EndRecord()
    {
        if (_isEmpty)
            return;
        Count++;
        (StampNanoseconds, ExposureMicroseconds) = (_stamp, _exposure);
        (_stamp, _exposure, _isEmpty) = (null, null, true);
    }

    // Null where the line has another name, or no number of at most 18 digits.
    private long? ValueOf(byte[] name)
    {
        ReadOnlySpan<byte> line = _line.AsSpan(0, _length);
        int digits = _length - name.Length;
        if (digits is < 1 or > 18 || !line.StartsWith(name))
            return null;
        long value = 0;
        foreach (byte digit in line.Slice(name.Length))
        {
            if (digit is < (byte)'0' or > (byte)'9')
                return null;
            value = (10 * value) + (digit - '0');
        }

        return value;
    }
}
