using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using Rabit.Uav.Messages;
using Rabit.Tests.Shared;
using Rabit.Vision;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// The template of the red panels that tests paint (tests/data/detection/red-panel.template), and the classes of a
/// detector for it. A training takes half a minute: <see cref="PanelTemplateTests"/> shows that it still gives
/// this file.
/// </summary>
internal static class PanelTemplate
{
    public const double PixelsPerMetre = 13;

    private static readonly Lazy<ObjectTemplate> Kept = new(() => ObjectTemplate.Load(FilePath));

    public static string FilePath => Path.Combine(Repository.Root, "tests", "data", "detection", "red-panel.template");

    public static ObjectTemplate Red => Kept.Value;

    public static ImmutableArray<TargetClass> Classes =>
        [new TargetClass(DefaultTargetClasses.Red.ToString()) { Template = Red }];

    /// <summary>
    /// What a camera sees through a red filter, from a column on: a template goes by brightness, and red panels are
    /// about as bright as grass.
    /// </summary>
    public static byte[] ThroughRedFilter(byte[] picture, int fromColumn = 0)
    {
        for (int i = 0; i < picture.Length; i += 3)
        {
            if (i / 3 % Painting.Width >= fromColumn)
                (picture[i + 1], picture[i + 2]) = (picture[i], picture[i]);
        }

        return picture;
    }

    public static ObjectTemplate Train()
    {
        var trainer = new TemplateTrainer(new TemplateTrainingOptions
        {
            Name = "red panel",
            LengthMetres = 1,
            WidthMetres = 1,
            MetresPerPixel = 0.055,
            FalseAlarmsPerPicture = 0.1,
        });
        for (int seed = 20; seed < 22; seed++)
        {
            var painting = new Painting(seed);
            var boxes = new List<TrainingBox>();
            for (int i = 0; i < 10; i++)
            {
                (double x, double y) = (60 + (115 * (i % 5)), 130 + (200 * (i / 5)));
                double angle = (0.16 * i) + (0.08 * (seed - 20));
                painting.Panel(DefaultTargetClasses.Red, x, y, PixelsPerMetre, angle);
                double side = PixelsPerMetre * (Math.Abs(Math.Cos(angle)) + Math.Abs(Math.Sin(angle)));
                boxes.Add(new TrainingBox(x + 0.5 - (side / 2), y + 0.5 - (side / 2), side, side)
                {
                    HeadingRadians = angle,
                });
            }

            trainer.Add(
                new RgbPicture(Painting.Width, Painting.Height, ThroughRedFilter(painting.Finish())),
                1 / PixelsPerMetre, boxes);
        }

        return trainer.Train().Template;
    }
}
