using System;
using System.Diagnostics;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using Rabit.Uav.ImageProcessing;
using VisionBench;

namespace Rabit.Vision.Speed;

/// <summary>The pictures of a set and the detectors that search them.</summary>
internal sealed class LoadedSet
{
    // Not in the reference assemblies of net472.
    private static readonly Func<long>? AllocatedBytesSoFar = (Func<long>?)typeof(GC)
        .GetMethod("GetAllocatedBytesForCurrentThread", BindingFlags.Public | BindingFlags.Static)
            ?.CreateDelegate(typeof(Func<long>));

    private readonly LoadedPicture[] _pictures;
    private readonly ShapeTargetDetector _shapes = new(BenchClasses.All);
    private readonly MarkerDetector _markers = new();
    private readonly TargetDetection[] _found = new TargetDetection[64];

    public LoadedSet(string folder)
    {
        var reader = new PictureReader();
        _pictures = PictureSet.Load(folder).Frames.Select(frame => Load(frame, reader)).ToArray();
    }

    /// <summary>Searches each picture so often; the shortest time counts.</summary>
    /// <exception cref="ArgumentException">There is no such operation.</exception>
    public PassResult Search(string operation, int repeats)
    {
        Func<LoadedPicture, int> search = operation switch
        {
            "shapes" => p => Detect(_shapes, p),
            "markers" => p => _markers.Find(p.Grey, p.Width, p.Height).Length,
            "read-colour" => p => ReadOnce(p.Pixels),
            "read-grey" => p => ReadOnce(p.Grey),
            _ => throw new ArgumentException($"{operation} is no operation", nameof(operation)),
        };
        (long ticks, long bytes, int found) = (0, 0, 0);
        foreach (LoadedPicture picture in _pictures)
        {
            long shortest = long.MaxValue;
            long allocated = AllocatedBytesSoFar?.Invoke() ?? 0;
            int count = 0;
            for (int i = 0; i < repeats; i++)
            {
                long start = Stopwatch.GetTimestamp();
                count = search(picture);
                shortest = Math.Min(shortest, Stopwatch.GetTimestamp() - start);
            }

            bytes += (AllocatedBytesSoFar?.Invoke() ?? 0) - allocated;
            ticks += shortest;
            found += count;
        }

        return new PassResult(
            1000.0 * ticks / Stopwatch.Frequency / _pictures.Length,
            (double)bytes / repeats / _pictures.Length,
            found);
    }

    private static LoadedPicture Load(ListedFrame frame, PictureReader reader)
    {
        (int width, int height) = (frame.Camera.Width, frame.Camera.Height);
        byte[] pixels = new byte[width * height * 3];
        byte[] grey = new byte[width * height];
        reader.LoadInto(frame.FilePath, width, height, pixels);
        GreyPixels.FromRgb(pixels, grey);
        return new LoadedPicture(pixels, grey, width, height, frame.CreateScale());
    }

    private int Detect(ITargetDetector detector, LoadedPicture picture)
    {
        var input = new DetectorInput(
            picture.Pixels, picture.Width, picture.Height, BenchClasses.All, picture.Scale);
        return detector.Detect(input, _found).Count;
    }

    // What no detector goes below: every byte is read once, eight at a time.
    private static int ReadOnce(byte[] pixels)
    {
        ReadOnlySpan<ulong> words = MemoryMarshal.Cast<byte, ulong>(pixels);
        (ulong a, ulong b, ulong c, ulong d) = (0, 0, 0, 0);
        for (int i = 0; i + 3 < words.Length; i += 4)
        {
            a |= words[i];
            b |= words[i + 1];
            c |= words[i + 2];
            d |= words[i + 3];
        }

        return (a | b | c | d) == 0 ? 0 : 1;
    }
}
