using System;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>A colour that targets are searched for in, and how large those of all its classes may be.</summary>
internal sealed class SearchedColour(ColourRange colour)
{
    public ColourRange Colour { get; } = colour;

    public double MinSideMetres { get; private set; } = double.PositiveInfinity;

    public double MaxSideMetres { get; private set; }

    /// <summary>Length of the longest.</summary>
    public double MaxSpanMetres { get; private set; }

    /// <summary>Whether a target of it may have parts of another colour between those of this one.</summary>
    public bool HasParts { get; private set; }

    public bool IsSame(ColourRange other)
        => Colour.Red == other.Red && Colour.Green == other.Green && Colour.Blue == other.Blue;

    public void Add(TargetClass target)
    {
        MinSideMetres = Math.Min(MinSideMetres, target.MinSideMetres);
        MaxSideMetres = Math.Max(MaxSideMetres, target.MaxSideMetres);
        MaxSpanMetres = Math.Max(MaxSpanMetres, target.MaxSideMetres * Math.Sqrt(target.MaxAspect));
        HasParts |= target.MinColourShare < 1;
    }
}
