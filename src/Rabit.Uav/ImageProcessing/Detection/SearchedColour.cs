using System;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>A colour that targets are searched for in, and how large those of all its classes may be.</summary>
internal sealed class SearchedColour(ColourRange colour)
{
    // What reaches further than a square of its area and its aspect.
    private const double SpanOfPointed = 1.25;

    private bool _hasWhole;
    private bool _hasPart;

    public ColourRange Colour { get; } = colour;

    public double MinSideMetres { get; private set; } = double.PositiveInfinity;

    public double MaxSideMetres { get; private set; }

    /// <summary>Length of the longest.</summary>
    public double MaxSpanMetres { get; private set; }

    /// <summary>Whether a target of it may have parts of another colour between those of this one.</summary>
    public bool HasParts { get; private set; }

    /// <summary>
    /// Whether it is the one colour of a class, and that of a small part of another one, as of the jacket of a person.
    /// </summary>
    public bool IsSharedWithPart => _hasWhole && _hasPart;

    public bool IsSame(ColourRange other)
        => Colour.Red == other.Red && Colour.Green == other.Green && Colour.Blue == other.Blue;

    public void Add(TargetClass target)
    {
        MinSideMetres = Math.Min(MinSideMetres, target.MinSideMetres);
        MaxSideMetres = Math.Max(MaxSideMetres, target.MaxSideMetres);
        MaxSpanMetres = Math.Max(
            MaxSpanMetres, target.MaxSideMetres * Math.Sqrt(target.MaxAspect) * SpanOf(target.Shape));
        _hasWhole |= target.MinColourShare == 1;
        _hasPart |= target.IsMostlyOfOtherColours;
        HasParts |= target.MinColourShare < 1;
    }

    private static double SpanOf(TargetShape shape)
        => shape is TargetShape.Cross or TargetShape.Triangle ? SpanOfPointed : 1;
}
