using System;
using System.IO;
using BenchmarkDotNet.Attributes;
using Rabit.Vision;

namespace Rabit.Benchmarks.Vision;

/// <summary>
/// Decoding a JPEG of 640 x 480 (4:2:0, quality 80), and another one that RABIT_JPEG names, beside libturbojpeg.
/// </summary>
[MemoryDiagnoser]
public class JpegBenchmarks
{
    private readonly JpegDecoder _decoder = new();
    private byte[] _file = [];
    private byte[] _pixels = [];
    private TurboJpeg? _turbo;

    [GlobalSetup]
    public void Open()
    {
        string path = Environment.GetEnvironmentVariable("RABIT_JPEG") is { Length: > 0 } named
            ? named
            : Path.Combine(AppContext.BaseDirectory, "data", "420-640x480.jpg");
        _file = File.ReadAllBytes(path);
        _decoder.Open(_file, 0, _file.Length, path);
        _pixels = new byte[_decoder.Width * _decoder.Height * 3];
        Console.WriteLine($"// {path}: {_decoder.Width} x {_decoder.Height}, {_file.Length} bytes");
        if (!TurboJpeg.IsInstalled)
            return;
        _turbo = new TurboJpeg();
        byte[] theirs = new byte[_pixels.Length];
        _turbo.Decode(_file, theirs, _decoder.Width, _decoder.Height);
        Rabit();
        if (!theirs.AsSpan().SequenceEqual(_pixels))
            throw new InvalidOperationException("Rabit and libturbojpeg give different pixels.");
    }

    [GlobalCleanup]
    public void Close() => _turbo?.Dispose();

    [Benchmark(Baseline = true)]
    public void LibTurboJpeg() => _turbo!.Decode(_file, _pixels, _decoder.Width, _decoder.Height);

    [Benchmark]
    public void Rabit()
    {
        _decoder.Open(_file, 0, _file.Length, "picture");
        _decoder.Decode(_pixels);
    }
}
