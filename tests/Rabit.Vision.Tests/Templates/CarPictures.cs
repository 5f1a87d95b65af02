using System;
using System.Collections.Generic;

namespace Rabit.Vision.Tests.Templates;

/// <summary>
/// Generated pictures from above: grey ground with noise and road marks, things that are no cars, and cars at any
/// heading, light and dark ones, with windows and a shadow.
/// </summary>
internal sealed class CarPictures(int seed)
{
    public const int Width = 300;
    public const int Height = 240;
    public const double MetresPerPixel = 0.15;

    private readonly Random _random = new(seed);

    public RgbPicture Picture { get; } = new(Width, Height, new byte[Width * Height * 3]);

    public List<(double X, double Y, double Heading)> Cars { get; } = [];

    public static CarPictures Create(int seed, int cars)
    {
        var made = new CarPictures(seed);
        made.Ground();
        for (int i = 0; i < 8; i++)
            made.Thing();
        for (int i = 0; i < cars; i++)
            made.Car();
        made.Noise();
        return made;
    }

    public List<TrainingBox> Boxes()
    {
        var boxes = new List<TrainingBox>();
        foreach ((double x, double y, double heading) in Cars)
        {
            (double length, double width) = (4.6 / MetresPerPixel, 1.9 / MetresPerPixel);
            double w = (length * Math.Abs(Math.Sin(heading))) + (width * Math.Abs(Math.Cos(heading)));
            double h = (length * Math.Abs(Math.Cos(heading))) + (width * Math.Abs(Math.Sin(heading)));
            boxes.Add(new TrainingBox(x + 0.5 - (w / 2), y + 0.5 - (h / 2), w, h));
        }

        return boxes;
    }

    private void Ground()
    {
        for (int i = 0; i < Width * Height; i++)
        {
            (int x, int y) = (i % Width, i / Width);
            int level = (int)(110 + (14 * Math.Sin(x * 0.03)) + (11 * Math.Sin((y * 0.05) + (x * 0.01))));
            Set(x, y, level);
        }
    }

    // Stripes, slabs and poles.
    private void Thing()
    {
        (double length, double width) = _random.Next(3) switch
        {
            0 => (12, 0.3),
            1 => (2.2, 2.2),
            _ => (0.8, 0.8),
        };
        Rectangle(
            _random.NextDouble() * Width, _random.NextDouble() * Height, _random.NextDouble() * Math.PI, 0, length,
            width, _random.Next(40, 230));
    }

    private void Car()
    {
        for (int attempt = 0; attempt < 100; attempt++)
        {
            double x = 30 + (_random.NextDouble() * (Width - 60));
            double y = 30 + (_random.NextDouble() * (Height - 60));
            if (Cars.Exists(c => Math.Abs(c.X - x) + Math.Abs(c.Y - y) < 55))
                continue;
            double heading = _random.NextDouble() * 2 * Math.PI;
            int paint = _random.Next(2) == 0 ? _random.Next(25, 70) : _random.Next(170, 240);
            Cars.Add((x, y, heading));
            Rectangle(x + 3, y + 3, heading, 0, 4.6, 1.9, 55);
            Rectangle(x, y, heading, 0, 4.6, 1.9, paint);
            Rectangle(x, y, heading, 0.9, 0.6, 1.6, 30);
            Rectangle(x, y, heading, -1.4, 0.5, 1.5, 35);
            return;
        }
    }

    // Its middle lies so many metres ahead of the place.
    private void Rectangle(
        double x, double y, double heading, double ahead, double length, double width, int level)
    {
        (double cos, double sin) = (Math.Cos(heading), Math.Sin(heading));
        for (int row = 0; row < Height; row++)
        {
            for (int column = 0; column < Width; column++)
            {
                double along = ((((column - x) * sin) - ((row - y) * cos)) * MetresPerPixel) - ahead;
                double across = (((column - x) * cos) + ((row - y) * sin)) * MetresPerPixel;
                if (Math.Abs(along) <= length / 2 && Math.Abs(across) <= width / 2)
                    Set(column, row, level);
            }
        }
    }

    private void Noise()
    {
        for (int i = 0; i < Width * Height; i++)
        {
            int level = Picture.Pixels[3 * i] + _random.Next(-8, 9);
            Set(i % Width, i / Width, Math.Max(0, Math.Min(255, level)));
        }
    }

    private void Set(int x, int y, int level)
    {
        int at = ((y * Width) + x) * 3;
        (Picture.Pixels[at], Picture.Pixels[at + 1], Picture.Pixels[at + 2]) = ((byte)level, (byte)level, (byte)level);
    }
}
