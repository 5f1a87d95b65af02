using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Ten thousand pictures, each another one, leave the detector and the heap as they were.</summary>
[Collection(AloneCollection.Name)]
public sealed class DetectorMemoryTests(ITestOutputHelper output)
{
    private const int Pictures = 10_000;
    private const int WarmUp = 1_000;
    private const double PixelsPerMetre = 13;

    private const int Between = 1_500;

    // What the runtime keeps for itself; what each picture left, were it 50 bytes only, would be more.
    private const long MaxGrowthBytes = 64 << 10;

    // One for each kind of detector that needs no trained template.
    private static readonly ImmutableArray<TargetClass> Classes =
    [
        .. TargetClass.Defaults,
        new("car")
        {
            Colour = new ColourRange(28, 72, 205), MinSideMetres = 2.3, MaxSideMetres = 3.6, MinAspect = 1.7,
            MaxAspect = 3.2, MinColourShare = 0.65,
        },
        new("person")
        {
            Colour = new ColourRange(28, 72, 205), MinSideMetres = 0.5, MaxSideMetres = 1.3, MinAspect = 1.3,
            MaxAspect = 4.5, MinColourShare = 0.35,
        },
        new("blue-yellow") { Colour = new ColourRange(28, 72, 205), SecondColour = new ColourRange(243, 214, 28) },
        new("white") { Colour = new ColourRange(236, 236, 232) },
        new("pad") { Marker = new TargetMarker(MarkerFamily.ArUco4x4), MinSideMetres = 0.5, MaxSideMetres = 3 },
    ];

    private readonly byte[] _picture = new byte[Painting.Width * Painting.Height * 3];

    [Fact, Trait("Category", "Long")]
    public void Detect_TenThousandPictures_AllocatesNothingAndKeepsNothing()
    {
        const int seed = 4;
        byte[][] painted = [.. Enumerable.Range(0, 8).Select(Paint)];
        var random = new Random(seed);
        var found = new TargetDetection[16];
        ITargetDetector detector = new ImageProcessingOptions { TargetClasses = Classes }.CreateDetector();
        var counts = new int[Classes.Length];
        var heap = new List<long>();
        (long detections, long most) = (0, 0);
        int allocating = 0;
        for (int number = 0; number < Pictures; number++)
        {
            if (number >= WarmUp && (number - WarmUp) % Between == 0)
                AddHeap(heap);
            Vary(painted[number % painted.Length], random);
            DetectorInput input = Input();
            int count = 0;
            long bytes = Allocated.By(() => count = detector.Detect(input, found).Count);
            if (number < WarmUp)
                continue;
            most = Math.Max(most, bytes);
            allocating += bytes > 0 ? 1 : 0;
            detections += count;
            foreach (TargetDetection one in found.AsSpan(0, count))
                counts[Classes.Select(c => c.Name).ToList().IndexOf(one.Class)]++;
        }

        AddHeap(heap);
        GC.KeepAlive(detector);
        GC.KeepAlive(painted);
        output.WriteLine($"seed {seed}: {detections} detections, heap {string.Join(", ", heap)}; found: "
            + string.Join(", ", Classes.Select((c, i) => $"{c.Name} {counts[i]}")));
        Assert.All(counts, c => Assert.True(c > 0, "a class was never found"));
        Assert.True(allocating == 0, $"{allocating} pictures allocated, up to {most} bytes");
        for (int i = 1; i < heap.Count; i++)
        {
            long grown = heap[i] - heap[i - 1];
            Assert.True(grown < MaxGrowthBytes, $"in {Between} pictures the heap grew by {grown} bytes");
        }
    }

    // What tests before this one left may go late: so it is not the first and the last that are compared.
    private static void AddHeap(List<long> heap)
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        heap.Add(GC.GetTotalMemory(forceFullCollection: true));
    }

    private DetectorInput Input()
        => new(
            _picture, Painting.Width, Painting.Height, Classes, PictureGroundScale.Uniform(1 / PixelsPerMetre));

    // Some of each class, and every second time ground that has the hue of yellow.
    private static byte[] Paint(int seed)
    {
        var painting = new Painting(seed);
        if (seed % 2 == 1)
            painting.Rectangle((93, 81, 30), 320, 240, Painting.Width, Painting.Height, 0);
        double angle = 0.4 * seed;
        for (int i = 0; i < 5; i++)
            painting.Panel(TargetClass.Defaults[i].Name, 70 + (100 * i), 70, 13, angle + i);
        painting.Rectangle((28, 72, 205), 100, 190, 4.4 * PixelsPerMetre, 1.8 * PixelsPerMetre, angle);
        painting.Rectangle((28, 72, 205), 240, 190, 1.7 * PixelsPerMetre, 0.5 * PixelsPerMetre, angle);
        painting.TwoColours((16, 40, 110), (148, 121, 18), 340, 190, 13, angle, isChequered: seed % 4 == 0);
        painting.Rectangle((236, 236, 232), 440, 190, 13, 13, angle);
        PaintMarker(painting, seed, 540, 190, 5);
        return painting.Finish();
    }

    private static void PaintMarker(Painting painting, int id, double x, double y, int cell)
    {
        int cells = MarkerPattern.CellsPerSide(MarkerFamily.ArUco4x4);
        for (int row = -1; row <= cells; row++)
        {
            for (int column = -1; column <= cells; column++)
            {
                double grey = MarkerPattern.IsWhite(MarkerFamily.ArUco4x4, id, row, column) ? 225 : 25;
                painting.Rectangle(
                    (grey, grey, grey), x + (column * cell), y + (row * cell), cell, cell, 0);
            }
        }
    }

    // Moved down and around, in another light, and one in eight of it with other noise.
    private void Vary(byte[] painted, Random random)
    {
        int down = random.Next(Painting.Height) * Painting.Width * 3;
        int light = random.Next(190, 300);
        int noise = random.Next(1, 9);
        for (int i = 0; i < painted.Length; i++)
        {
            int from = i + down;
            int value = painted[from < painted.Length ? from : from - painted.Length] * light >> 8;
            if ((i & 7) == 0)
                value += random.Next(-noise, noise + 1);
            _picture[i] = (byte)Math.Max(0, Math.Min(255, value));
        }
    }
}
