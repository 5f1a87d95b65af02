using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Hosting;

/// <summary>What the text of a setting stands for. Immutable.</summary>
internal static class SettingText
{
    // No more than a file of its kind has: a device given by mistake has no end.
    private const int MaxFileLength = 64_000_000;

    public static bool Knows(Type type)
        => type.IsEnum || type == typeof(string) || type == typeof(bool) || type == typeof(byte)
            || type == typeof(int) || type == typeof(long) || type == typeof(double) || type == typeof(TimeSpan)
            || type == typeof(Angle) || type == typeof(LinkUrl) || type == typeof(MissionPlan)
            || type == typeof(TerrainGrid) || type == typeof(MissionProgress);

    /// <exception cref="FormatException">It is none; the text says what it must be.</exception>
    /// <exception cref="IOException">A file cannot be read. Or what else reading it throws.</exception>
    public static object Parse(Type type, string text)
    {
        if (type.IsEnum)
            return ParseEnum(type, text);
        if (type == typeof(string))
            return text;
        if (type == typeof(bool))
            return bool.TryParse(text, out bool flag) ? flag : throw Not("true or false");
        if (type == typeof(TimeSpan))
            return ParseTime(text);
        if (type == typeof(Angle))
            return Angle.FromDegrees(ParseNumber(text, "an angle in degrees"));
        if (type == typeof(double))
            return ParseNumber(text, "a number");
        if (type == typeof(LinkUrl))
            return LinkUrl.TryParse(text, out LinkUrl? url, out string? error)
                ? url!
                : throw new FormatException(error);
        if (type == typeof(MissionPlan))
            return MissionPlan.Parse(
                ReadFile(text), Path.GetFileName(text), Path.GetDirectoryName(Path.GetFullPath(text)));
        if (type == typeof(MissionProgress))
            return MissionProgress.ReadFile(text);
        if (type == typeof(TerrainGrid))
            return AsciiGrid.Read(new StringReader(ReadFile(text)));
        return ParseWhole(type, text);
    }

    private static object ParseEnum(Type type, string text)
    {
        string[] names = Enum.GetNames(type);
        bool isKnown = text.Split(',').All(t => names.Contains(t.Trim(), StringComparer.OrdinalIgnoreCase));
        bool isOne = text.All(c => c != ',') || type.IsDefined(typeof(FlagsAttribute), inherit: false);
        return isKnown && isOne
            ? Enum.Parse(type, text, ignoreCase: true)
            : throw Not("one of " + string.Join(", ", names));
    }

    private static TimeSpan ParseTime(string text)
        // "5" would be five days.
        => text.Any(c => c == ':') && TimeSpan.TryParse(text, CultureInfo.InvariantCulture, out TimeSpan time)
            ? time
            : throw Not("a time, as 00:00:02.5");

    private static double ParseNumber(string text, string what)
        => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
            && !double.IsNaN(number) && !double.IsInfinity(number)
            ? number
            : throw Not(what);

    private static object ParseWhole(Type type, string text)
    {
        (long min, long max) = type == typeof(byte) ? (byte.MinValue, byte.MaxValue)
            : type == typeof(int) ? (int.MinValue, int.MaxValue)
            : (long.MinValue, long.MaxValue);
        return long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long number)
            && number >= min && number <= max
            ? Convert.ChangeType(number, type, CultureInfo.InvariantCulture)
            : throw Not(FormattableString.Invariant($"a whole number from {min} to {max}"));
    }

    private static string ReadFile(string path)
    {
        if (new FileInfo(path) is { Exists: true, Length: > MaxFileLength })
            throw new IOException(FormattableString.Invariant($"it is longer than {MaxFileLength} bytes"));
        return File.ReadAllText(path);
    }

    private static FormatException Not(string what) => new("it must be " + what);
}
