using System;
using System.Buffers.Text;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Reads the numbers of a file of the kernel. Allocates nothing; null where the text is another.</summary>
internal static class KernelText
{
    public static long? Number(ReadOnlySpan<byte> text)
        => Utf8Parser.TryParse(TrimStart(text), out long value, out _) ? value : null;

    public static long? HexNumber(ReadOnlySpan<byte> text)
    {
        text = TrimStart(text);
        if (text.Length > 1 && text[0] == '0' && text[1] is (byte)'x' or (byte)'X')
            text = text.Slice(2);
        return Utf8Parser.TryParse(text, out long value, out _, 'X') ? value : null;
    }

    /// <summary>The number after a name at the beginning of a line.</summary>
    public static long? NumberAfter(ReadOnlySpan<byte> text, ReadOnlySpan<byte> name)
    {
        while (TakeLine(ref text, out ReadOnlySpan<byte> line))
        {
            if (line.StartsWith(name))
                return Number(line.Slice(name.Length));
        }

        return null;
    }

    public static bool TakeLine(ref ReadOnlySpan<byte> text, out ReadOnlySpan<byte> line)
    {
        int end = text.IndexOf((byte)'\n');
        line = end < 0 ? text : text.Slice(0, end);
        text = end < 0 ? default : text.Slice(end + 1);
        return line.Length > 0;
    }

    public static bool TakeNumber(ref ReadOnlySpan<byte> line, out long value)
    {
        line = TrimStart(line);
        if (!Utf8Parser.TryParse(line, out value, out int length))
            return false;
        line = line.Slice(length);
        return true;
    }

    private static ReadOnlySpan<byte> TrimStart(ReadOnlySpan<byte> text)
    {
        int start = 0;
        while (start < text.Length && text[start] is (byte)' ' or (byte)'\t')
            start++;
        return text.Slice(start);
    }
}
