using System;
using System.IO;
using System.Reflection;
using Rabit.Benchmarks.Vision;

namespace Rabit.Vision.Speed;

/// <summary>
/// What has a limit of its own: decoding a JPEG beside libturbojpeg, and the place of a pixel in a large grid of
/// terrain. The best of many passes in turn, so that a busy machine makes little difference.
/// </summary>
internal static class Limits
{
    private const double MaxTimesLibrary = 3;
    private const double MaxTerrainMilliseconds = 1;
    private const int Passes = 200;

    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    /// <summary>Measures and prints.</summary>
    /// <returns>
    /// Whether all limits are kept. They are those of .NET; under Mono there are figures and no limits.
    /// </returns>
    public static bool Check(TextWriter output)
    {
        output.WriteLine(FormattableString.Invariant(
            $"{(IsMono ? "Mono" : ".NET")} {Environment.Version}, one core, the best of {Passes} passes in turn"));
        bool isJpegGood = CheckJpeg(output);
        return CheckTerrain(output) && isJpegGood;
    }

    private static bool CheckJpeg(TextWriter output)
    {
        string folder = Path.GetDirectoryName(Assembly.GetExecutingAssembly().Location)!;
        byte[] file = File.ReadAllBytes(Path.Combine(folder, "data", "420-640x480.jpg"));
        var decoder = new JpegDecoder(mayUseLibrary: false);
        decoder.Open(file, 0, file.Length, "picture");
        (int width, int height) = (decoder.Width, decoder.Height);
        byte[] pixels = new byte[width * height * 3];
        var own = new TimedWork(() =>
        {
            decoder.Open(file, 0, file.Length, "picture");
            decoder.Decode(pixels);
        });
        string name = FormattableString.Invariant($"a JPEG of {width} x {height}, {file.Length} bytes");
        if (!TurboJpeg.IsInstalled)
        {
            TimedWork.Measure(Passes, own);
            output.WriteLine(FormattableString.Invariant(
                $"{name}: {own.BestMilliseconds:0.000} ms; SKIPPED beside libturbojpeg, which is not installed (Debian: libturbojpeg0)"));
            return true;
        }

        using var library = new TurboJpeg();
        byte[] theirs = new byte[pixels.Length];
        var other = new TimedWork(() => library.Decode(file, theirs, width, height));
        TimedWork.Measure(Passes, own, other);
        if (!theirs.AsSpan().SequenceEqual(pixels))
        {
            output.WriteLine($"{name}: FAILED, other pixels than libturbojpeg's");
            return false;
        }

        double ratio = own.BestMilliseconds / other.BestMilliseconds;
        bool isGood = IsMono || ratio <= MaxTimesLibrary;
        output.WriteLine(FormattableString.Invariant(
            $"{name}: {own.BestMilliseconds:0.000} ms, libturbojpeg {other.BestMilliseconds:0.000} ms, ratio {ratio:0.00}, limit {MaxTimesLibrary}{Mark(isGood)}"));
        return isGood;
    }

    private static bool CheckTerrain(TextWriter output)
    {
        var pixel = new TerrainPixel();
        var work = new TimedWork(pixel.Locate);
        TimedWork.Measure(Passes, work);
        bool isGood = IsMono || work.BestMilliseconds < MaxTerrainMilliseconds;
        output.WriteLine(FormattableString.Invariant(
            $"a pixel's place {pixel.Kilometres:0} km away in a terrain grid of 111 km with one peak, and its covariances: {work.BestMilliseconds:0.0000} ms, limit {MaxTerrainMilliseconds} ms{Mark(isGood)}"));
        return isGood;
    }

    private static string Mark(bool isGood) => IsMono ? " (of .NET)" : isGood ? "" : "  TOO MUCH";
}
