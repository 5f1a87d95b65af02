using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What a panel of a class must be like, and how like it is.</summary>
internal sealed class PanelClass
{
    // Side of the smallest panel that can be distinguished from other things, pixels.
    private const double MinSidePixels = 5.5;

    // Of the rectangle around it, and of its two sides beyond those of the class.
    private const double MinFill = 0.8;

    // The corners of a small one are not seen; but what is smaller again may be anything.
    private const double MinFillOfSmall = 0.785;
    private const double SmallFromPixels = 7;
    private const double SmallToPixels = 8.5;
    private const double AspectSlack = 1.1;

    // What a colour may have of the outline. The blur takes from what is dark, and gives to what is bright; a hue
    // between two may show neither.
    private const double MinDarkShare = 0.3;
    private const double MinBrightShare = 0.06;
    private const double MinHueShare = 0.12;

    // Of a panel of one colour, nothing else is seen. A bright stone and the shade of a bush are like small panels: it
    // must be large enough, as bright as paper or as dark as cloth by the light of the ground, and even.
    private const double MinOnlyShare = 0.75;
    private const double MinOnlySidePixels = 8;
    private const double MinWhiteByGround = 2.4;
    private const double MaxBlackByGround = 0.2;
    private const double MaxUnevenness = 0.35;

    // One standard deviation of a good one.
    private const double FillSpread = 0.15;
    private const double RingSpread = 0.25;

    // Of the centre, pixels; and what the mixing of two colours at the edge comes to, by the side.
    private const double BaseSigma = 0.06;
    private const double SideSigma = 0.006;

    // So much longer than wide, a panel has a direction of its own, and not that of any of its sides.
    private const double MinLongAspect = 1.25;

    // Of its direction: by whole pixels of its outline, pixels, and by the steps of the fit.
    private const double OutlineSigma = 0.5;
    private const double FitSigmaRadians = 0.25 * Angle.RadiansPerDegree;

    private readonly TargetClass _target;

    public PanelClass(TargetClass target)
        => (_target, Colours) = (target, new PanelColours(target.Colour!, target.SecondColour));

    public TargetClassName Name => _target.Name;

    public PanelColours Colours { get; }

    public bool HasTwoColours => _target.SecondColour is not null;

    /// <summary>Whether it is large enough in a picture to be searched for.</summary>
    public bool IsResolved(in PixelSides sides) => sides.IsGround && UsualSideMetres / sides.Finest >= MinSidePixels;

    public bool IsIn(ImmutableArray<TargetClass> wanted)
    {
        foreach (TargetClass one in wanted)
        {
            if (one.Name == Name)
                return true;
        }

        return false;
    }

    /// <summary>What may be one in a picture.</summary>
    public PanelLimits LimitsFor(in PixelSides sides) => new()
    {
        MinSide = Math.Max(_target.MinSideMetres / sides.Coarsest, MinSidePixels / 2),
        MaxSide = _target.MaxSideMetres * Math.Sqrt(_target.MaxAspect) / sides.Finest,
        UsualSide = UsualSideMetres / Math.Sqrt(sides.Finest * sides.Coarsest),
        MeasuresForm = _target.Shape != TargetShape.Any,
    };

    /// <summary>The score, 0 to 1; 0 where it is none.</summary>
    /// <param name="shape">What was found.</param>
    /// <param name="rectangle">Around it on the ground, metres.</param>
    /// <param name="pixel">Side of a pixel there, metres.</param>
    public double Score(in PanelShape shape, in FittedRectangle rectangle, double pixel)
    {
        double side = pixel * Math.Sqrt(shape.OutlinePixels);
        double aspect = rectangle.Length / rectangle.Width;
        double fill = shape.OutlinePixels * pixel * pixel / (rectangle.Length * rectangle.Width);
        bool hasForm = HasForm(shape, fill, side / pixel, out double form);
        bool isPanel = hasForm && side >= _target.MinSideMetres && side <= _target.MaxSideMetres
            && UsualSideMetres >= MinSidePixels * pixel
            && aspect <= _target.MaxAspect * AspectSlack && aspect >= _target.MinAspect / AspectSlack
            && HasColours(shape);
        if (!isPanel)
            return 0;
        double size = Math.Log(side / UsualSideMetres)
            / Math.Log(Math.Sqrt(_target.MaxSideMetres / _target.MinSideMetres));
        double ring = shape.CoveredRing / RingSpread;
        return Math.Exp(-0.25 * ((size * size) + (form * form) + (ring * ring)));
    }

    /// <summary>Where it points; null for a shape that has no such direction.</summary>
    /// <param name="rectangle">Around it on the ground, metres.</param>
    /// <param name="pixel">Side of a pixel there, metres.</param>
    public TargetBearing? BearingOfPanel(in FittedRectangle rectangle, double pixel)
        => _target.Shape is TargetShape.Any or TargetShape.Rectangle ? BearingOf(rectangle, pixel) : null;

    /// <summary>Where a rectangle points.</summary>
    /// <param name="rectangle">On the ground, metres.</param>
    /// <param name="pixel">Side of a pixel there, metres.</param>
    public static TargetBearing BearingOf(in FittedRectangle rectangle, double pixel)
    {
        bool hasLongSide = rectangle.Length > MinLongAspect * rectangle.Width;
        double byOutline = OutlineSigma * pixel / Math.Sqrt(rectangle.Length * rectangle.Width);
        return new TargetBearing(
            Angle.FromRadians(rectangle.AngleRadians),
            Angle.FromRadians(Math.Sqrt((byOutline * byOutline) + (FitSigmaRadians * FitSigmaRadians))),
            hasLongSide ? BearingSymmetry.HalfTurn : BearingSymmetry.QuarterTurn);
    }

    /// <summary>How uncertain the centre is.</summary>
    public static PixelCovariance CovarianceOf(in PanelShape shape)
        => PixelCovariance.FromSigma(
            Math.Sqrt((BaseSigma * BaseSigma) + (SideSigma * SideSigma * shape.Area)));

    private bool HasForm(in PanelShape shape, double fill, double sidePixels, out double deviation)
    {
        if (_target.Shape == TargetShape.Any)
        {
            deviation = Math.Max(0, 1 - fill) / FillSpread;
            return fill >= MinFillAt(sidePixels);
        }

        double cost = FormCost.Of(shape.Form, _target.Shape, shape.OutlinePixels, isOfWholePixels: true);
        deviation = Math.Sqrt(cost);
        return cost <= PatchCandidates.MaxCost;
    }

    private static double MinFillAt(double sidePixels)
        => sidePixels is >= SmallFromPixels and <= SmallToPixels ? MinFillOfSmall : MinFill;

    // The middle of the range, as a ratio.
    private double UsualSideMetres => Math.Sqrt(_target.MinSideMetres * _target.MaxSideMetres);

    private bool HasColours(in PanelShape shape)
        => _target.SecondColour is null
            ? IsOfOneColour(shape)
            : HasShare(_target.Colour!, shape.FirstShare) && HasShare(_target.SecondColour, shape.SecondShare);

    private bool IsOfOneColour(in PanelShape shape)
        => shape.FirstShare >= MinOnlyShare && shape.Unevenness <= MaxUnevenness
            && shape.OutlinePixels >= MinOnlySidePixels * MinOnlySidePixels
            && (PanelColours.IsWhite(_target.Colour!)
                ? shape.BrightnessByGround >= MinWhiteByGround
                : shape.BrightnessByGround <= MaxBlackByGround);

    private static bool HasShare(ColourRange colour, double share)
        => PanelColours.IsBlack(colour) ? share >= MinDarkShare
            : PanelColours.IsWhite(colour) ? share >= MinBrightShare
            : share >= MinHueShare;
}
