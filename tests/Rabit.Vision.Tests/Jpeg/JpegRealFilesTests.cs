using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text.Json;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Jpeg;

/// <summary>JPEG files of cameras, libraries and fuzzers, against what libjpeg-turbo 2.1.5 makes of them.</summary>
public sealed class JpegRealFilesTests(ITestOutputHelper output)
{
    // With libturbojpeg, where it is installed, progressive files are decoded too.
    [RealPicturesTheory("jpeg")]
    [InlineData(false)]
    [InlineData(true)]
    public void Decode_FilesOfMany_GivesThePixelsOrRefusesAsExpected(bool mayUseLibrary)
    {
        bool readsProgressive = new JpegDecoder(mayUseLibrary).Engine != new JpegDecoder(false).Engine;
        string folder = RealPicturesFactAttribute.FolderOf("jpeg")!;
        using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "manifest.json")));
        var faults = new List<string>();
        int files = 0;
        foreach (JsonElement entry in manifest.RootElement.GetProperty("files").EnumerateArray())
        {
            files++;
            string name = entry.GetProperty("file").GetString()!;
            string result = Decode(Path.Combine(folder, name), entry, mayUseLibrary);
            string expected = entry.GetProperty("expected").GetString()!;
            if (readsProgressive && IsProgressive(entry))
                expected = entry.GetProperty("djpeg").GetProperty("fancy").GetProperty("exit").GetInt32() == 0
                    ? "decode"
                    : "refuse";
            output.WriteLine($"{name}: {result}, expected {expected}");
            bool isRight = expected switch
            {
                "decode" => result == "the same pixels",
                "refuse" => result.StartsWith("refused", StringComparison.Ordinal),
                _ => result != "another size",
            };
            if (!isRight)
                faults.Add($"{name}: {result}");
        }

        Assert.Empty(faults);
        Assert.Equal(83, files);
    }

    private static bool IsProgressive(JsonElement entry)
        => entry.GetProperty("kind").TryGetProperty("sof", out JsonElement kind)
            && kind.ValueKind == JsonValueKind.String
            && kind.GetString()!.Contains("progressive", StringComparison.Ordinal);

    private static string Decode(string path, JsonElement entry, bool mayUseLibrary)
    {
        RgbPicture picture;
        try
        {
            picture = JpegFiles.Decode(File.ReadAllBytes(path), "it", mayUseLibrary);
        }
        catch (PictureException e)
        {
            return "refused: " + e.Message;
        }

        JsonElement kind = entry.GetProperty("kind");
        if (picture.Width != kind.GetProperty("width").GetInt32()
            || picture.Height != kind.GetProperty("height").GetInt32())
            return "another size";
        JsonElement reference = entry.GetProperty("djpeg").GetProperty("fancy");
        byte[] samples = kind.GetProperty("components").GetInt32() == 1
            ? picture.Pixels.Where((_, at) => at % 3 == 0).ToArray()
            : picture.Pixels;
        using var sha = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        sha.AppendData(samples);
        string hash = string.Concat(sha.GetHashAndReset().Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
        return hash == reference.GetProperty("sha256").GetString() ? "the same pixels" : "other pixels";
    }
}
