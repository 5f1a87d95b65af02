using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Templates;

/// <summary>
/// Cars in frames of a drone's video, at full and half resolution, by templates that were trained with the other videos
/// and three photos straight down.
/// </summary>
public sealed class CarsFromAboveTests(ITestOutputHelper output)
{
    private const double CarLength = 4.8;

    // A longer box is a bus, and counts neither way.
    private const double MaxLength = 7.5;

    private static readonly string[] Photos = ["minsk_DJI_0010_s.jpg", "minsk_DJI_0012_s.jpg", "minsk_DJI_0022_s.jpg"];

    [RealPicturesFact("aerial")]
    [Trait("Category", "Long")]
    public void Scan_VideoLeftOutOfTraining_FindsItsCars()
    {
        List<LabelledFrame> frames = Load();
        Assert.Equal(94, frames.Where(f => f.Video.Length > 0).Sum(f => f.Boxes.Count));
        var full = new List<(double Score, bool IsCar)>();
        var half = new List<(double Score, bool IsCar)>();
        foreach (IGrouping<string, LabelledFrame> video in frames.Where(f => f.Video.Length > 0).GroupBy(f => f.Video))
        {
            ObjectTemplate template = Train(frames.Where(f => f.Video != video.Key));
            var scanner = new TemplateScanner(template);
            foreach (LabelledFrame frame in video)
            {
                full.AddRange(Score(scanner, frame.Picture, frame.MetresPerPixel, frame.Boxes, 1));
                half.AddRange(Score(scanner, Halved(frame.Picture), 2 * frame.MetresPerPixel, frame.Boxes, 0.5));
            }
        }

        int cars = frames.Where(f => f.Video.Length > 0).Sum(f => f.Boxes.Count(b => !IsLong(b, f.MetresPerPixel)));
        Check("full", full, cars);
        Check("half", half, cars);
    }

    private void Check(string name, List<(double Score, bool IsCar)> found, int cars)
    {
        double one = Recall(found, cars, 5);
        double two = Recall(found, cars, 10);
        output.WriteLine(FormattableString.Invariant(
            $"{name} resolution: recall {one:0.000} at one and {two:0.000} at two false alarms a picture, of {cars} cars"));
        Assert.True(one >= 0.72 && two >= 0.84, $"{name}: {one}, {two}");
    }

    // Of five pictures together, with one threshold.
    private static double Recall(List<(double Score, bool IsCar)> found, int cars, int falseAlarms)
    {
        (int right, int wrong) = (0, 0);
        foreach ((_, bool isCar) in found.OrderByDescending(f => f.Score))
        {
            if (!isCar && ++wrong > falseAlarms)
                break;
            right += isCar ? 1 : 0;
        }

        return (double)right / cars;
    }

    // One group: nothing is left out, and nothing trained beside it.
    private static ObjectTemplate Train(IEnumerable<LabelledFrame> frames)
    {
        var trainer = new TemplateTrainer(new TemplateTrainingOptions { Name = "car" });
        foreach (LabelledFrame frame in frames)
            trainer.Add(frame.Picture, frame.MetresPerPixel, frame.Boxes, "all");
        ObjectTemplate template = trainer.Train().Template;
        template.Threshold = -1.5;
        return template;
    }

    private static List<(double Score, bool IsCar)> Score(
        TemplateScanner scanner, RgbPicture picture, double metresPerPixel, List<TrainingBox> boxes, double scale)
    {
        scanner.Begin(picture.Pixels, picture.Width, picture.Height);
        Assert.True(scanner.Scan(
            PlaneScale.Uniform(metresPerPixel), 0, 0, picture.Width - 1, picture.Height - 1));
        var taken = new HashSet<TrainingBox>();
        var scores = new List<(double Score, bool IsCar)>();
        foreach (TemplateMatch match in scanner.Finish())
        {
            (double x, double y) = ((match.CentreX + 0.5) / scale, (match.CentreY + 0.5) / scale);
            TrainingBox[] inside = boxes.Where(b => x >= b.Left && x <= b.Left + b.Width && y >= b.Top
                && y <= b.Top + b.Height).ToArray();
            TrainingBox? car = inside.Where(b => !IsLong(b, metresPerPixel * scale) && !taken.Contains(b))
                .OrderBy(b => Square(b.Left + (b.Width / 2) - x) + Square(b.Top + (b.Height / 2) - y))
                .FirstOrDefault();
            if (car is not null)
                taken.Add(car);
            if (car is not null || !inside.Any(b => IsLong(b, metresPerPixel * scale)))
                scores.Add((match.Score, car is not null));
        }

        return scores;
    }

    private static List<LabelledFrame> Load()
    {
        string folder = RealPicturesFactAttribute.FolderOf("aerial")!;
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "manifest.json")));
        var frames = new List<LabelledFrame>();
        foreach (JsonElement entry in json.RootElement.GetProperty("files").EnumerateArray())
        {
            string name = Path.GetFileName(entry.GetProperty("file").GetString()!);
            bool isFrame = entry.TryGetProperty("boxes_px", out JsonElement boxes);
            if (!isFrame && !Photos.Contains(name))
                continue;
            double scale = isFrame ? 1 : entry.GetProperty("scale").GetDouble();
            if (!isFrame)
                boxes = entry.GetProperty("boxes_original_px");
            frames.Add(new LabelledFrame(
                new PictureReader().Load(Path.Combine(folder, "small", name)),
                isFrame ? name.Substring(0, name.LastIndexOf('-')) : "",
                boxes.EnumerateArray().Select(b => BoxOf(b, scale)).ToList()));
        }

        return frames;
    }

    private static TrainingBox BoxOf(JsonElement box, double scale)
        => new(
            box.GetProperty("x").GetDouble() * scale, box.GetProperty("y").GetDouble() * scale,
            box.GetProperty("w").GetDouble() * scale, box.GetProperty("h").GetDouble() * scale);

    private static RgbPicture Halved(RgbPicture picture)
    {
        (int width, int height) = (picture.Width / 2, picture.Height / 2);
        byte[] pixels = new byte[width * height * 3];
        for (int i = 0; i < pixels.Length; i++)
        {
            int at = (((i / 3 / width * 2 * picture.Width) + (i / 3 % width * 2)) * 3) + (i % 3);
            int below = at + (picture.Width * 3);
            pixels[i] = (byte)((picture.Pixels[at] + picture.Pixels[at + 3] + picture.Pixels[below]
                + picture.Pixels[below + 3] + 2) / 4);
        }

        return new RgbPicture(width, height, pixels);
    }

    private static bool IsLong(TrainingBox box, double metresPerPixel)
        => Math.Max(box.Width, box.Height) * metresPerPixel > MaxLength;

    private static double Square(double value) => value * value;

    private sealed class LabelledFrame
    {
        public LabelledFrame(RgbPicture picture, string video, List<TrainingBox> boxes)
        {
            (Picture, Video, Boxes) = (picture, video, boxes);
            double[] sides = boxes
                .Where(b => Math.Max(b.Width, b.Height) > 1.6 * Math.Min(b.Width, b.Height))
                .Select(b => Math.Max(b.Width, b.Height)).OrderBy(s => s).ToArray();
            MetresPerPixel = CarLength / ((sides[(sides.Length - 1) / 2] + sides[sides.Length / 2]) / 2);
        }

        public RgbPicture Picture { get; }

        /// <summary>Which video it is of; empty for a photo.</summary>
        public string Video { get; }

        public List<TrainingBox> Boxes { get; }

        public double MetresPerPixel { get; }
    }
}
