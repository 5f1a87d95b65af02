using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.Json;

namespace Rabit.Mavlink.Tests;

/// <summary>Where the test data is, and the small things read from it by several tests.</summary>
internal static class TestData
{
    // Not the base directory: where tests run without a domain of their own, as under Mono, that is the runner's.
    public static string Folder { get; } =
        Path.Combine(Path.GetDirectoryName(typeof(TestData).Assembly.Location)!, "data", "mavlink");

    public static string PathOf(string file) => Path.Combine(Folder, file);

    public static byte[] Bytes(string file) => File.ReadAllBytes(PathOf(file));

    public static JsonDocument Json(string path) => JsonDocument.Parse(File.ReadAllText(path));

    public static byte[] FromHex(string hex)
    {
        var bytes = new byte[hex.Length / 2];
        for (int i = 0; i < bytes.Length; i++)
            bytes[i] = (byte)((HexDigit(hex[2 * i]) << 4) | HexDigit(hex[(2 * i) + 1]));
        return bytes;
    }

    public static string ToHex(byte[] bytes, int count)
    {
        var hex = new System.Text.StringBuilder(2 * count);
        for (int i = 0; i < count; i++)
            hex.Append(bytes[i].ToString("x2", CultureInfo.InvariantCulture));
        return hex.ToString();
    }

    private static int HexDigit(char digit) => digit <= '9' ? digit - '0' : digit - 'a' + 10;

    public static IEnumerable<JsonElement> Lines(string file)
    {
        foreach (string line in File.ReadLines(PathOf(file)))
        {
            using var document = JsonDocument.Parse(line);
            yield return document.RootElement.Clone();
        }
    }
}
