using System;
using System.Collections.Generic;

namespace Rabit.Vision;

/// <summary>The windows about an object that a template is trained with: turned, mirrored, and a little off.</summary>
internal sealed class TrainingWindows
{
    private const int Border = 2;   // cells, that of TemplateRefiner
    private const int Each = 2;     // at each of four symmetries
    private const double MaxTurn = Math.PI / 24;
    private const double MaxScale = 0.08;

    private readonly TemplateRefiner _windows = new();

    /// <summary>Adds them.</summary>
    public void Add(
        TrainingPicture picture, TrainingObject one, double heading, ObjectTemplate template, SampleRandom random,
        List<float[]> to)
    {
        for (int i = 0; i < 4 * Each; i++)
        {
            double turn = heading + (i % 2 * Math.PI) + (MaxTurn * Spread(random));
            double scale = 1 + (MaxScale * Spread(random));
            double alongPixels = template.CellPixels / 2.0 * Spread(random);
            double acrossPixels = template.CellPixels / 2.0 * Spread(random);
            to.Add(Window(picture, one, turn, scale, alongPixels, acrossPixels, i / 2 % 2 == 1, template));
        }
    }

    /// <summary>The better score of the two directions of a heading.</summary>
    public double Score(TrainingPicture picture, TrainingObject one, double heading, ObjectTemplate template)
        => Math.Max(
            FloatRows.Dot(Window(picture, one, heading, 1, 0, 0, false, template), template.Weights),
            FloatRows.Dot(Window(picture, one, heading + Math.PI, 1, 0, 0, false, template), template.Weights));

    private static double Spread(SampleRandom random) => (2 * random.Next()) - 1;

    private float[] Window(
        TrainingPicture picture, TrainingObject one, double heading, double scale, double along, double across,
        bool isMirrored, ObjectTemplate template)
    {
        int columns = template.WindowLength + (2 * Border * template.CellPixels);
        int rows = template.WindowWidth + (2 * Border * template.CellPixels);
        var window = PlaneWindow.Along(picture.Scale, heading, template.MetresPerPixel * scale);
        if (isMirrored)
            (window.ColumnByRow, window.RowByRow) = (-window.ColumnByRow, -window.RowByRow);
        window.Put(((columns - 1) / 2.0) + along, ((rows - 1) / 2.0) + across, one.Box.CentreX, one.Box.CentreY);
        return _windows.Values(picture.Plane, template, window).ToArray();
    }
}
