using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Vision;

/// <summary>What a template is to be trained for.</summary>
public sealed class TemplateTrainingOptions
{
    private const int MaxNameLength = 64;
    private const int CellPixels = 4;
    private const int Headings = 12;
    private const double PixelsPerLength = 32;

    // The window shows a part of the ground around the object, by parts of the length.
    private const double LengthAround = 0.5;
    private const double WidthAround = 1.0 / 3;

    /// <summary>What it is called: 1 to 64 printable ASCII characters.</summary>
    /// <value>The default is "object".</value>
    public string Name { get; set; } = "object";

    /// <summary>Length of the usual object, metres.</summary>
    /// <value>The default is 4.8 m: a car.</value>
    public double LengthMetres { get; set; } = 4.8;

    /// <summary>Width of the usual object, metres.</summary>
    /// <value>The default is 2 m: a car.</value>
    public double WidthMetres { get; set; } = 2;

    /// <summary>Side of a pixel on the ground at which pictures are searched; null for a 32nd of the length.</summary>
    /// <value>
    /// The default is null. Finer takes longer; pictures more than 1.7 times coarser cannot be searched.
    /// </value>
    public double? MetresPerPixel { get; set; }

    /// <summary>
    /// How many false alarms there may be for each picture: the threshold of the template is set for it, by pictures
    /// that were left out of training.
    /// </summary>
    /// <value>The default is 1.</value>
    public double FalseAlarmsPerPicture { get; set; } = 1;

    internal ObjectTemplate CreateTemplate()
    {
        var template = new ObjectTemplate
        {
            Name = Name,
            LengthMetres = LengthMetres,
            WidthMetres = WidthMetres,
            MetresPerPixel = MetresPerPixel ?? LengthMetres / PixelsPerLength,
            CellPixels = CellPixels,
            Headings = Headings,
            Slope = 2,
        };
        double cell = template.MetresPerPixel * CellPixels;
        template.CellsLong = (int)Math.Round(Math.Min(LengthMetres * (1 + LengthAround) / cell, 1e6));
        template.CellsWide = (int)Math.Round(Math.Min((WidthMetres + (WidthAround * LengthMetres)) / cell, 1e6));
        template.SigmaMetres = cell / 4;
        return template;
    }

    internal IEnumerable<string> FindFaults()
    {
        if (Name is null || Name.Length is 0 or > MaxNameLength || Name.Any(c => c is < ' ' or > '~'))
            yield return $"the name must have 1 to {MaxNameLength} printable ASCII characters";
        if (!(FalseAlarmsPerPicture > 0 && FalseAlarmsPerPicture <= 1000))
            yield return FormattableString.Invariant(
                $"{nameof(FalseAlarmsPerPicture)} is {FalseAlarmsPerPicture}; it must be above 0, at most 1000");
        foreach (string fault in CreateTemplate().FindFaults())
            yield return fault;
    }
}
