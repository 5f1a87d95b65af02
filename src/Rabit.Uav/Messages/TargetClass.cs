using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using Rabit.Vision;

namespace Rabit.Uav.Messages;

/// <summary>
/// A class of targets that the user declares: its name, the size it may have, and its colour. Immutable.
/// </summary>
public sealed class TargetClass
{
    // A marker is read from about 14 pixels on, and a panel found from 4.
    private const double PanelsPerMarker = 3.5;

    // One of two colours is found from about 6 pixels on, of black or white from 8.
    private const double PanelsPerTwoColours = 1.4;
    private const double PanelsPerNeutral = 2;

    private const double HalfOfIt = 0.5;

    // A template is found in pixels half as fine again, which must be finer than a quarter of this.
    private const double PixelsPerTemplatePixel = 6;

    /// <summary>Declares a class.</summary>
    /// <param name="name">
    /// 1 to 16 printable ASCII characters: in reports, tracks, the mission file, and between vehicles.
    /// </param>
    /// <exception cref="ArgumentException">The name is none of that kind.</exception>
    public TargetClass(string name) => Name = new TargetClassName(name);

    // A square that is seen aslant, small or hidden in part.
    private TargetClass(TargetClassName name, ColourRange colour)
        => (Name, Colour, MaxAspect) = (name, colour, 1.7);

    /// <summary>Square panels of about 1 m in five colours: <see cref="DefaultTargetClasses"/>.</summary>
    public static ImmutableArray<TargetClass> Defaults { get; } =
    [
        new(DefaultTargetClasses.Red, new ColourRange(205, 28, 32)),
        new(DefaultTargetClasses.Orange, new ColourRange(242, 112, 18)),
        new(DefaultTargetClasses.Blue, new ColourRange(28, 72, 205)),
        new(DefaultTargetClasses.Yellow, new ColourRange(243, 214, 28)),
        new(DefaultTargetClasses.Magenta, new ColourRange(212, 36, 150)),
    ];

    /// <summary>Its name.</summary>
    public TargetClassName Name { get; }

    /// <summary>Side of the smallest target, that of a square of its area, metres.</summary>
    /// <value>The default is 0.6 m, for panels of 1 m.</value>
    public double MinSideMetres { get; init; } = 0.6;

    /// <summary>Side of the largest target, that of a square of its area, metres.</summary>
    /// <value>The default is 1.5 m, for panels of 1 m.</value>
    public double MaxSideMetres { get; init; } = 1.5;

    /// <summary>How much longer than wide it is at least, on the ground; 1 for what may be a square.</summary>
    /// <value>The default is 1.</value>
    public double MinAspect { get; init; } = 1;

    /// <summary>How much longer than wide it is at most, on the ground.</summary>
    /// <value>The default is 2.</value>
    public double MaxAspect { get; init; } = 2;

    /// <summary>
    /// The least part of it that shows its colour: less than 1 for what has parts of another one, as a car has windows.
    /// Of less than 0.5 most is of other colours, which lie beside that one, as the trousers beside a jacket.
    /// </summary>
    /// <value>The default is 1.</value>
    public double MinColourShare { get; init; } = 1;

    /// <summary>
    /// Its colour, which <see cref="ImageProcessing.ShapeTargetDetector"/> needs: what has the same one as another
    /// class must differ in size or form. Other detectors may leave it null.
    /// </summary>
    public ColourRange? Colour { get; init; }

    /// <summary>
    /// The other colour of a panel of two, beside each other in any pattern: for
    /// <see cref="ImageProcessing.PanelTargetDetector"/>, which also finds panels of black or white alone. Null, the
    /// default, for what has one colour.
    /// </summary>
    public ColourRange? SecondColour { get; init; }

    /// <summary>
    /// Its outline, for panels of one or two colours: what has another one is then none of it. It can be made out from
    /// some 12 pixels on (a cross from 16), of two colours from 24. Sides are always those of a square of its area. It
    /// is for what shows its colours all over (<see cref="MinColourShare"/> of 1).
    /// </summary>
    /// <value>The default is <see cref="TargetShape.Any"/>.</value>
    public TargetShape Shape { get; init; }

    /// <summary>
    /// The printed markers that it consists of; the size is then the side of the black square. Null, the default, for
    /// what is no marker.
    /// </summary>
    public TargetMarker? Marker { get; init; }

    /// <summary>
    /// What it looks like from above, trained from labelled pictures: for
    /// <see cref="ImageProcessing.TemplateTargetDetector"/>. The side of its object must be one of those that the class
    /// may have. Null, the default, for what has none.
    /// </summary>
    public ObjectTemplate? Template { get; init; }

    /// <summary>
    /// That it is warmer than the ground around it, in pictures of a thermal camera: for
    /// <see cref="ImageProcessing.HotSpotTargetDetector"/>. Null, the default, for what is seen by light.
    /// </summary>
    public HotSpotTarget? HotSpot { get; init; }

    /// <summary>
    /// Whether <see cref="ImageProcessing.PanelTargetDetector"/> can find it: a panel of two colours, of black or of
    /// white. The default detector finds white ones by their form.
    /// </summary>
    public bool IsPanel => Colour is not null && Marker is null && Template is null && HotSpot is null
        && (SecondColour is not null
            || (MinColourShare == 1 && (PanelColours.IsBlack(Colour) || PanelColours.IsWhite(Colour))));

    /// <summary>
    /// Whether it is found by its one colour and its form, with <see cref="ImageProcessing.ShapeTargetDetector"/>: what
    /// has nothing else to be found by.
    /// </summary>
    internal bool IsForm => Marker is null && Template is null && HotSpot is null && !IsPanel;

    /// <summary>
    /// Whether most of it is of other colours, which lie beside its own: of a person the jacket shows it.
    /// </summary>
    internal bool IsMostlyOfOtherColours => MinColourShare < HalfOfIt;

    // What must be resolved of it as four pixels are of a panel: of a marker, that its cells can be read, and of a
    // template, its edges.
    internal double ResolvedSideMetres
        => Marker is not null ? MinSideMetres / PanelsPerMarker
            : Template is not null ? Template.MetresPerPixel * PixelsPerTemplatePixel
            : IsPanel ? MinSideMetres / (SecondColour is null ? PanelsPerNeutral : PanelsPerTwoColours)
            : MinSideMetres;

    internal static IEnumerable<string> FindFaults(ImmutableArray<TargetClass> classes)
    {
        if (classes.IsDefaultOrEmpty)
            yield return "there is no target class";
        var names = new HashSet<TargetClassName>();
        foreach (TargetClass targetClass in classes.IsDefault ? [] : classes)
        {
            if (targetClass is null)
            {
                yield return "a target class is null";
                continue;
            }

            if (!names.Add(targetClass.Name))
                yield return $"target class {targetClass.Name} is declared twice";
            (double min, double max) = (targetClass.MinSideMetres, targetClass.MaxSideMetres);
            if (!(min > 0 && min < max && !double.IsInfinity(max)))
            {
                yield return FormattableString.Invariant(
                    $"{nameof(MinSideMetres)} of target class {targetClass.Name} is {min} and {nameof(MaxSideMetres)} {max}; they must be above 0 and in this order");
            }

            (min, max) = (targetClass.MinAspect, targetClass.MaxAspect);
            if (!(min >= 1 && min < max && !double.IsInfinity(max)))
            {
                yield return FormattableString.Invariant(
                    $"{nameof(MinAspect)} of target class {targetClass.Name} is {min} and {nameof(MaxAspect)} {max}; they must be at least 1 and in this order");
            }

            if (!(targetClass.MinColourShare > 0 && targetClass.MinColourShare <= 1))
            {
                yield return FormattableString.Invariant(
                    $"{nameof(MinColourShare)} of target class {targetClass.Name} is {targetClass.MinColourShare}; it must be above 0, at most 1");
            }

            foreach (string fault in targetClass.Marker?.FindFaults(targetClass) ?? [])
                yield return fault;
            foreach (string fault in targetClass.HotSpot?.FindFaults(targetClass) ?? [])
                yield return fault;
            foreach (string fault in targetClass.FindTemplateFaults())
                yield return fault;
            if (targetClass.FindShapeFault() is { } shape)
                yield return $"target class {targetClass.Name} {shape}";
            if (targetClass.FindColourFault() is { } colours)
                yield return $"the colours of target class {targetClass.Name}: {colours}";
        }
    }

    private string? FindShapeFault()
        => Shape == TargetShape.Any ? null
            : Shape is < TargetShape.Any or > TargetShape.Triangle ? $"has the {nameof(Shape)} {Shape}, which is none"
            : Marker is not null || Template is not null || HotSpot is not null
                ? $"has the {nameof(Shape)} {Shape} and a marker, a template or a hot spot; "
                    + "it can only have one of them"
            : Colour is null ? $"has the {nameof(Shape)} {Shape} and no {nameof(Colour)}, which it is seen by"
            : MinColourShare < 1 ? FormattableString.Invariant(
                $"has the {nameof(Shape)} {Shape} and a {nameof(MinColourShare)} of {MinColourShare}; what has a shape shows its colours all over, 1")
            : null;

    private string? FindColourFault()
        => SecondColour is null ? null
            : Colour is null ? $"it has a {nameof(SecondColour)}, and no {nameof(Colour)}"
            : PanelColours.FindFault(Colour, SecondColour);

    private IEnumerable<string> FindTemplateFaults()
    {
        if (Template is null)
            yield break;
        if (Colour is not null || Marker is not null)
            yield return $"target class {Name} has a template and a colour or a marker; it can only have one of them";
        double side = Math.Sqrt(Template.LengthMetres * Template.WidthMetres);
        if (!(side >= MinSideMetres && side <= MaxSideMetres))
        {
            yield return FormattableString.Invariant(
                $"the template of target class {Name} is for objects with a side of {side:0.00} m (a square of their area), which is not within its {nameof(MinSideMetres)} of {MinSideMetres} and {nameof(MaxSideMetres)} of {MaxSideMetres}");
        }
    }
}
