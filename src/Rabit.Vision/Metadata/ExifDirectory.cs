using System;
using System.Collections.Generic;
using System.Text;

namespace Rabit.Vision;

/// <summary>
/// A directory of EXIF that is put together: its entries in the order of their tags, and behind them what is longer
/// than four bytes. Big-endian.
/// </summary>
internal sealed class ExifDirectory
{
    private const int EntryBytes = 12;
    private const int TypeByte = 1;
    private const int TypeText = 2;
    private const int TypeShort = 3;
    private const int TypeLong = 4;
    private const int TypeRational = 5;
    private const int TypeUndefined = 7;

    private readonly List<(int Tag, int Type, int Count, byte[] Value)> _entries = [];

    /// <summary>How long it is with so many numbers of four bytes that are still to come.</summary>
    public int BytesWith(int moreNumbers)
    {
        int bytes = 2 + (EntryBytes * (_entries.Count + moreNumbers)) + 4;
        foreach ((_, _, _, byte[] value) in _entries)
            bytes += Behind(value);
        return bytes;
    }

    public void AddText(int tag, string? text)
    {
        if (string.IsNullOrEmpty(text))
            return;
        byte[] value = Encoding.ASCII.GetBytes(text + "\0");
        _entries.Add((tag, TypeText, value.Length, value));
    }

    public void AddShort(int tag, int number)
        => _entries.Add((tag, TypeShort, 1, [(byte)(number >> 8), (byte)number, 0, 0]));

    public void AddLong(int tag, int number) => _entries.Add((tag, TypeLong, 1, Number((uint)number)));

    public void AddBytes(int tag, params byte[] bytes) => _entries.Add((tag, TypeByte, bytes.Length, bytes));

    public void AddUndefined(int tag, byte[] bytes) => _entries.Add((tag, TypeUndefined, bytes.Length, bytes));

    /// <summary>Numbers from 0 on, as exactly as two whole numbers of 32 bits can say them.</summary>
    public void AddRationals(int tag, params double[] numbers)
    {
        var value = new List<byte>();
        foreach (double number in numbers)
        {
            uint denominator = 100_000_000;
            while (denominator > 1 && number * denominator > uint.MaxValue)
                denominator /= 10;
            value.AddRange(Number((uint)Math.Round(Math.Min(number * denominator, uint.MaxValue))));
            value.AddRange(Number(denominator));
        }

        _entries.Add((tag, TypeRational, numbers.Length, [.. value]));
    }

    /// <summary>Writes it behind what is there.</summary>
    public void AppendTo(List<byte> file)
    {
        int behind = file.Count + 2 + (EntryBytes * _entries.Count) + 4;
        file.AddRange([(byte)(_entries.Count >> 8), (byte)_entries.Count]);
        foreach ((int tag, int type, int count, byte[] value) in _entries)
        {
            file.AddRange([(byte)(tag >> 8), (byte)tag, 0, (byte)type]);
            file.AddRange(Number((uint)count));
            if (value.Length > 4)
            {
                file.AddRange(Number((uint)behind));
                behind += Behind(value);
            }
            else
            {
                file.AddRange(value);
                file.AddRange(new byte[4 - value.Length]);
            }
        }

        file.AddRange(new byte[4]);   // no directory after it
        foreach ((_, _, _, byte[] value) in _entries)
        {
            if (value.Length <= 4)
                continue;
            file.AddRange(value);
            file.AddRange(new byte[Behind(value) - value.Length]);
        }
    }

    // On an even place, as TIFF has it.
    private static int Behind(byte[] value) => value.Length <= 4 ? 0 : value.Length + (value.Length % 2);

    private static byte[] Number(uint value)
        => [(byte)(value >> 24), (byte)(value >> 16), (byte)(value >> 8), (byte)value];
}
