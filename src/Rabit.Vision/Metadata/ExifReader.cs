using System;
using System.Collections.Generic;
using System.Globalization;

namespace Rabit.Vision;

/// <summary>
/// Reads EXIF (CIPA DC-008-2019), which is a TIFF of directories. Three of them are read, each once, so that no chain
/// of them goes in circles; a value that does not lie in the segment is a fault and is left out.
/// </summary>
internal sealed class ExifReader(byte[] file, int start, int length, PhotoMetadata photo, List<string> faults)
{
    private const int EntryBytes = 12;
    private const int MaxFaults = 20;

    public const double MaxExposureSeconds = 3600;
    public const double MaxMetres = 100_000;
    public const double MaxNumber = 1e6;   // of what is above 0

    private static readonly int[] TypeBytes = [0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8];

    private bool _isBig;
    private string? _date;
    private string? _fraction;
    private string? _offset;
    private string? _gpsDate;
    private double[]? _gpsTime;
    private double[]? _latitude;
    private double[]? _longitude;
    private string? _latitudeSide;
    private string? _longitudeSide;
    private double? _altitude;
    private bool _isBelowSea;

    private delegate void Take(int tag, int type, int count, int at);

    public void Read()
    {
        bool isTiff = length >= 8 && file[start] == file[start + 1] && file[start] is (byte)'I' or (byte)'M';
        _isBig = isTiff && file[start] == 'M';
        if (!isTiff || Short(2) != 42)
        {
            Fault("it does not begin as it must");
            return;
        }

        (long exif, long gps) = (0, 0);
        ReadDirectory(Long(4), "first", (tag, type, count, at) =>
        {
            if (tag == 0x8769)
                exif = (long)Number(type, at);
            else if (tag == 0x8825)
                gps = (long)Number(type, at);
            else
                TakeFirst(tag, type, count, at);
        });
        if (exif != 0)
            ReadDirectory(exif, "EXIF", TakeExif);
        if (gps != 0)
            ReadDirectory(gps, "GPS", TakeGps);
        Finish();
    }

    private void TakeFirst(int tag, int type, int count, int at)
    {
        switch (tag)
        {
            case 0x010F:
                photo.Make = Text(type, count, at);
                break;
            case 0x0110:
                photo.Model = Text(type, count, at);
                break;
            case 0x0112 when Number(type, at) is >= 1 and <= 8:
                photo.Orientation = (int)Number(type, at);
                break;
        }
    }

    private void TakeExif(int tag, int type, int count, int at)
    {
        switch (tag)
        {
            case 0x829A when Number(type, at) is > 0 and <= MaxExposureSeconds and double seconds:
                photo.ExposureTime = TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));
                break;
            case 0x9003:
                _date = Text(type, count, at);
                break;
            case 0x9011:
                _offset = Text(type, count, at);
                break;
            case 0x9291:
                _fraction = Text(type, count, at);
                break;
            case 0x920A:
                photo.FocalLengthMillimetres = Positive(Number(type, at));
                break;
            case 0xA002:
                photo.PixelWidth = (int?)Positive(Number(type, at));
                break;
            case 0xA003:
                photo.PixelHeight = (int?)Positive(Number(type, at));
                break;
            case 0xA405:
                photo.FocalLength35MillimetreEquivalentMillimetres = Positive(Number(type, at));
                break;
        }
    }

    private void TakeGps(int tag, int type, int count, int at)
    {
        switch (tag)
        {
            case 1:
                _latitudeSide = Text(type, count, at);
                break;
            case 2:
                _latitude = Three(type, count, at);
                break;
            case 3:
                _longitudeSide = Text(type, count, at);
                break;
            case 4:
                _longitude = Three(type, count, at);
                break;
            case 5:
                _isBelowSea = Number(type, at) is 1 or 3;   // against the ellipsoid or the sea since EXIF 3.0
                break;
            case 6:
                _altitude = Number(type, at);
                break;
            case 7:
                _gpsTime = Three(type, count, at);
                break;
            case 0x10:
                photo.IsImageDirectionMagnetic = Text(type, count, at) == "M";
                break;
            case 0x11 when Number(type, at) is >= 0 and <= 360:
                photo.ImageDirectionDegrees = Number(type, at);
                break;
            case 0x1D:
                _gpsDate = Text(type, count, at);
                break;
        }
    }

    private void Finish()
    {
        if (_altitude is { } altitude && Math.Abs(altitude) < MaxMetres)
            photo.AltitudeAmslMetres = _isBelowSea ? -Math.Abs(altitude) : altitude;
        TakePosition();
        TakeTime();
    }

    private void TakePosition()
    {
        if (_latitude is null || _longitude is null)
            return;
        double latitude = Degrees(_latitude) * (_latitudeSide == "S" ? -1 : 1);
        double longitude = Degrees(_longitude) * (_longitudeSide == "W" ? -1 : 1);
        if (!(Math.Abs(latitude) <= 90 && Math.Abs(longitude) <= 180) || _latitudeSide is not ("N" or "S")
            || _longitudeSide is not ("E" or "W"))
            Fault("its position is none");
        else if (latitude == 0 && longitude == 0)
            Fault("its position is 0, 0, as cameras without a fix write it");
        else
            (photo.LatitudeDegrees, photo.LongitudeDegrees) = (latitude, longitude);
    }

    private void TakeTime()
    {
        const DateTimeStyles Style = DateTimeStyles.None;
        if (_date is not null)
        {
            if (DateTime.TryParseExact(
                _date, "yyyy:MM:dd HH:mm:ss", CultureInfo.InvariantCulture, Style, out DateTime taken)
                && taken.Year is > 1 and < 9999)
                (photo.TakenLocal, photo.TakenResolution) = WithFraction(taken);
            else
                Fault("its time is none: " + _date);
        }

        if (PhotoMetadata.TryParseUtcOffset(_offset, out TimeSpan offset))
            photo.UtcOffset = offset;
        if (_gpsDate is not null && _gpsTime is not null && DateTime.TryParseExact(
            _gpsDate, "yyyy:MM:dd", CultureInfo.InvariantCulture, Style, out DateTime day)
            && (_gpsTime[0] * 3600) + (_gpsTime[1] * 60) + _gpsTime[2] is >= 0 and < 86_401 and double seconds
            && day.Year < 9999)
            photo.PositionTimeUtc = new DateTimeOffset(day, TimeSpan.Zero)
                + TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond));
    }

    private (DateTime Taken, TimeSpan Resolution) WithFraction(DateTime taken)
    {
        string digits = _fraction?.Trim() ?? string.Empty;
        if (digits.Length == 0 || !double.TryParse(
            "0." + digits, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double fraction))
            return (taken, TimeSpan.FromSeconds(1));
        double step = Math.Pow(10, -digits.Length);
        return (
            taken + TimeSpan.FromTicks((long)Math.Round(fraction * TimeSpan.TicksPerSecond)),
            TimeSpan.FromTicks(Math.Max(1, (long)Math.Round(step * TimeSpan.TicksPerSecond))));
    }

    private static double Degrees(double[] parts) => parts[0] + (parts[1] / 60) + (parts[2] / 3600);

    private static double? Positive(double value) => value > 0 && value < MaxNumber ? value : null;

    private void ReadDirectory(long offset, string name, Take take)
    {
        if (offset < 8 || offset > length - 2)
        {
            Fault($"its {name} directory does not lie in it");
            return;
        }

        int entries = Short((int)offset);
        for (int number = 0; number < entries; number++)
        {
            long entry = offset + 2 + (EntryBytes * (long)number);
            if (entry > length - EntryBytes)
            {
                Fault($"its {name} directory is cut off");
                return;
            }

            ReadEntry((int)entry, take);
        }
    }

    private void ReadEntry(int entry, Take take)
    {
        int tag = Short(entry);
        int type = Short(entry + 2);
        long count = Long(entry + 4);
        if (type < 1 || type >= TypeBytes.Length || count < 1)
            return;
        long bytes = count * TypeBytes[type];
        long at = bytes <= 4 ? entry + 8 : Long(entry + 8);
        if (bytes > length || at > length - bytes)
            Fault($"the value of tag {tag:X4} does not lie in it");
        else
            take(tag, type, (int)count, (int)at);
    }

    private string? Text(int type, int count, int at)
    {
        if (type != 2)
            return null;
        char[] text = new char[Math.Min(count, 256)];
        int used = 0;
        for (; used < text.Length && file[start + at + used] != 0; used++)
            text[used] = file[start + at + used] is >= 32 and < 127 and byte character ? (char)character : '?';
        string trimmed = new string(text, 0, used).Trim();
        return trimmed.Length == 0 ? null : trimmed;
    }

    private double[]? Three(int type, int count, int at)
    {
        if (count != 3 || type is not (5 or 10))
            return null;
        double[] three = [Number(type, at), Number(type, at + 8), Number(type, at + 16)];
        return double.IsNaN(three[0] + three[1] + three[2]) ? null : three;
    }

    // NaN for what is no number.
    private double Number(int type, int at) => type switch
    {
        1 => file[start + at],
        3 => Short(at),
        4 => Long(at),
        9 => (int)Long(at),
        5 => Long(at + 4) == 0 ? double.NaN : (double)Long(at) / Long(at + 4),
        10 => Long(at + 4) == 0 ? double.NaN : (double)(int)Long(at) / (int)Long(at + 4),
        _ => double.NaN,
    };

    private int Short(int at)
    {
        (byte a, byte b) = (file[start + at], file[start + at + 1]);
        return _isBig ? (a << 8) | b : (b << 8) | a;
    }

    private long Long(int at)
    {
        (long a, long b) = (Short(at), Short(at + 2));
        return _isBig ? (a << 16) | b : (b << 16) | a;
    }

    private void Fault(string reason)
    {
        if (faults.Count < MaxFaults)
            faults.Add("EXIF: " + reason);
    }
}
