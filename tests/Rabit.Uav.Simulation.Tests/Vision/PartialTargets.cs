using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>
/// Drawn pictures of targets of one kind: in full sight, hidden in part by something that is no ground, cut by the
/// border of the picture, or overexposed. At least half of each can be seen.
/// </summary>
internal sealed class PartialTargets
{
    private const double MinPixels = 6;
    private const double MinSeen = 0.5;
    private const double MaxSeenOfPartial = 0.95;
    private const int Samples = 5;

    private static readonly (string Name, byte Red, byte Green, byte Blue)[] Colours =
    [
        ("red", 205, 28, 32), ("orange", 242, 112, 18), ("blue", 28, 72, 205), ("yellow", 243, 214, 28),
        ("magenta", 212, 36, 150),
    ];

    // Crowns of trees, a dark roof, a light one, bare soil, a grey sheet.
    private static readonly (double Red, double Green, double Blue)[] Covers =
    [
        (0.035, 0.075, 0.02), (0.05, 0.1, 0.03), (0.09, 0.085, 0.08), (0.42, 0.41, 0.38), (0.16, 0.11, 0.07),
        (0.25, 0.26, 0.27),
    ];

    private readonly List<PartialTarget> _targets = [];
    private readonly Random _random;
    private readonly PartialKind _kind;

    public PartialTargets(int seed, PartialKind kind)
    {
        (_random, _kind) = (new Random(seed), kind);
        var scene = new DrawnScene(seed);
        MetresPerPixel = 0.06 + (0.1 * _random.NextDouble());
        for (int i = 0; i < 12; i++)
            Draw(scene, i);
        double gain = kind == PartialKind.Clipped
            ? 1.5 + _random.NextDouble() : 0.9 + (0.2 * _random.NextDouble());
        Pixels = scene.Finish(0.5 + (0.45 * _random.NextDouble()), gain, 90 + _random.Next(8));
    }

    public static ImmutableArray<TargetClass> Classes { get; } =
    [
        .. Colours.Select(c => new TargetClass(c.Name)
        {
            Colour = new ColourRange(c.Red, c.Green, c.Blue), MinSideMetres = 0.85, MaxSideMetres = 2.1,
        }),
    ];

    public byte[] Pixels { get; }

    public double MetresPerPixel { get; }

    public IEnumerable<PartialTarget> Targets
        => _targets.Where(t => _kind != PartialKind.Clipped || IsClipped(t.Form));

    private void Draw(DrawnScene scene, int i)
    {
        double side = Math.Max(MinPixels, (0.95 + _random.NextDouble()) / MetresPerPixel);
        (double x, double y) = PlaceOf(i, side);
        var form = new DrawnForm(
            (TargetShape)(1 + _random.Next(4)), x, y, side, 2 * Math.PI * _random.NextDouble(),
            0.3 + (0.1 * _random.NextDouble()));
        DrawnForm? cover = _kind == PartialKind.Hidden ? CoverOf(form) : null;
        (double seenX, double seenY, double seen) = Seen(form, cover);
        (string name, byte red, byte green, byte blue) = Colours[_random.Next(Colours.Length)];
        double light = 0.85 + (0.3 * _random.NextDouble());
        scene.Draw(form.Contains, x, y, form.Reach, DrawnScene.Linear(red, green, blue, light));
        if (cover is not null)
            Draw(scene, cover);
        if (seen >= MinSeen && (_kind is PartialKind.Clear or PartialKind.Clipped || seen < MaxSeenOfPartial))
            _targets.Add(new PartialTarget(form, name, seenX, seenY, seen));
    }

    private void Draw(DrawnScene scene, DrawnForm cover)
    {
        (double red, double green, double blue) = Covers[_random.Next(Covers.Length)];
        scene.Draw(cover.Contains, cover.X, cover.Y, cover.Reach, (red, green, blue));
        for (int i = 0; i < 12; i++)
        {
            (double u, double v) = (_random.NextDouble() - 0.5, _random.NextDouble() - 0.5);
            var spot = new DrawnForm(
                TargetShape.Circle, cover.X + (u * cover.Side), cover.Y + (v * cover.Side), 0.2 * cover.Side, 0);
            double light = 0.7 + (0.6 * _random.NextDouble());
            scene.Draw(
                (column, row) => spot.Contains(column, row) && cover.Contains(column, row), spot.X, spot.Y, spot.Reach,
                (light * red, light * green, light * blue));
        }
    }

    // It hides from a twentieth to a half.
    private DrawnForm? CoverOf(DrawnForm form)
    {
        for (int trial = 0; trial < 50; trial++)
        {
            double side = form.Side * (0.7 + (1.5 * _random.NextDouble()));
            double direction = 2 * Math.PI * _random.NextDouble();
            double away = (0.3 + (0.7 * _random.NextDouble())) * (form.Side + side) / 2;
            var cover = new DrawnForm(
                _random.Next(2) == 0 ? TargetShape.Circle : TargetShape.Rectangle,
                form.X + (away * Math.Cos(direction)), form.Y + (away * Math.Sin(direction)), side,
                2 * Math.PI * _random.NextDouble());
            if (Seen(form, cover).Part is >= MinSeen and < MaxSeenOfPartial)
                return cover;
        }

        return null;
    }

    private static (double X, double Y, double Part) Seen(DrawnForm form, DrawnForm? cover)
    {
        (double x, double y, int all, int seen) = (0, 0, 0, 0);
        int reach = (int)(Samples * form.Reach);
        for (int i = -reach; i <= reach; i++)
        {
            for (int j = -reach; j <= reach; j++)
            {
                (double column, double row) = (form.X + (i / (double)Samples), form.Y + (j / (double)Samples));
                if (!form.Contains(column, row))
                    continue;
                all++;
                if (column < -0.5 || row < -0.5 || column > DrawnScene.Width - 0.5 || row > DrawnScene.Height - 0.5
                    || cover?.Contains(column, row) == true)
                    continue;
                (x, y, seen) = (x + column, y + row, seen + 1);
            }
        }

        return (x / Math.Max(1, seen), y / Math.Max(1, seen), seen / (double)all);
    }

    // Half of the pixels about its middle have a channel at its end.
    private bool IsClipped(DrawnForm form)
    {
        int reach = (int)Math.Max(1, form.Side / 4);
        (int clipped, int all) = (0, 0);
        for (int row = (int)form.Y - reach; row <= (int)form.Y + reach; row++)
        {
            for (int column = (int)form.X - reach; column <= (int)form.X + reach; column++)
            {
                int at = ((row * DrawnScene.Width) + column) * 3;
                all++;
                clipped += Pixels[at] >= 250 || Pixels[at + 1] >= 250 || Pixels[at + 2] >= 250 ? 1 : 0;
            }
        }

        return 2 * clipped >= all;
    }

    // In rows and columns; what is to be cut, at the borders.
    private (double X, double Y) PlaceOf(int i, double side)
    {
        double along = 60 + (95 * (i % 6)) + (30 * _random.NextDouble());
        double off = side * (_random.NextDouble() - 0.5) * 0.9;
        if (_kind == PartialKind.Cut)
        {
            return i % 4 < 2
                ? (along, i < 6 ? off : DrawnScene.Height - 1 - off)
                : (i < 6 ? off : DrawnScene.Width - 1 - off, 60 + (0.7 * along));
        }

        return (80 + (155 * (i % 4)) + (30 * _random.NextDouble()),
            80 + (150 * (i / 4)) + (30 * _random.NextDouble()));
    }
}
