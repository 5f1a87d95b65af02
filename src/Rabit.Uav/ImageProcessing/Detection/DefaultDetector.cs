using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Makes the default detector: one for each kind of class that is declared, and for each white more than one, together
/// as one detector where there are several.
/// </summary>
internal static class DefaultDetector
{
    /// <param name="classes">Checked, and with no fault that <see cref="FindFaults"/> finds.</param>
    public static ITargetDetector Create(ImmutableArray<TargetClass> classes)
    {
        // A thermal camera sees nothing else.
        ImmutableArray<TargetClass> hotSpots = [.. classes.Where(c => c.HotSpot is not null)];
        if (!hotSpots.IsEmpty)
            return new HotSpotTargetDetector(hotSpots);

        // What is found by more than one colour and its form comes first.
        var parts = new List<PartDetector>();
        Add(parts, [.. classes.Where(c => c.Marker is not null)], own => new MarkerTargetDetector(own));
        Add(parts, FindPanels(classes), own => new PanelTargetDetector(own));
        Add(parts, [.. classes.Where(c => c.Template is not null)], own => new TemplateTargetDetector(own));
        ImmutableArray<TargetClass> forms = FindForms(classes);
        foreach (IGrouping<(byte, byte, byte), TargetClass> ofOneWhite in classes
            .Where(c => IsWhitePanel(c) && !forms.Contains(c))
            .GroupBy(c => (c.Colour!.Red, c.Colour.Green, c.Colour.Blue)))
            Add(parts, [.. ofOneWhite], own => new ShapeTargetDetector(own));
        Add(parts, forms, own => new ShapeTargetDetector(own));
        return parts.Count == 1 ? parts[0].Detector : new CombinedTargetDetector([.. parts]);
    }

    /// <summary>Why it cannot be made.</summary>
    public static IEnumerable<string> FindFaults(ImmutableArray<TargetClass> classes)
        => ShapeTargetDetector.FindColourFaults(FindForms([.. classes.Where(c => c is not null)]));

    private static void Add(
        List<PartDetector> parts, ImmutableArray<TargetClass> own,
        Func<ImmutableArray<TargetClass>, ITargetDetector> make)
    {
        if (!own.IsEmpty)
            parts.Add(new PartDetector(make(own), own));
    }

    private static ImmutableArray<TargetClass> FindPanels(ImmutableArray<TargetClass> classes)
        => [.. classes.Where(c => c.IsPanel && !IsWhitePanel(c))];

    // White panels too, unless that detector would have to know two whites, as with a silver car: then there is one
    // detector more for each white.
    private static ImmutableArray<TargetClass> FindForms(ImmutableArray<TargetClass> classes)
    {
        ImmutableArray<TargetClass> forms = [.. classes.Where(c => c.IsForm)];
        ImmutableArray<TargetClass> withWhites = [.. classes.Where(c => c.IsForm || IsWhitePanel(c))];
        return ShapeTargetDetector.FindColourFaults(withWhites).Any() ? forms : withWhites;
    }

    private static bool IsWhitePanel(TargetClass target)
        => target is { IsPanel: true, SecondColour: null } && PanelColours.IsWhite(target.Colour!);
}
