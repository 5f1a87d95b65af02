using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace VisionBench;

/// <summary>
/// What the pictures are searched for: the targets that the README of the generated sets describes, and panels of
/// photos.
/// </summary>
internal static class BenchClasses
{
    private static readonly (string Name, ColourRange Range)[] Colours =
    [
        ("red", new ColourRange(205, 28, 32)),
        ("orange", new ColourRange(242, 112, 18)),
        ("blue", new ColourRange(28, 72, 205)),
        ("yellow", new ColourRange(243, 214, 28)),
        ("magenta", new ColourRange(212, 36, 150)),
        ("white", new ColourRange(236, 236, 234)),
    ];

    /// <summary>Panels, cars and persons.</summary>
    public static ImmutableArray<TargetClass> All { get; } =
    [
        .. Colours.Select(c => new TargetClass("panel-" + c.Name)
        {
            Colour = c.Range, MinSideMetres = 0.85, MaxSideMetres = 2.1, MaxAspect = 2,
        }),
        .. Colours.Where(c => c.Name is "red" or "blue" or "yellow" or "white")
            .Select(c => new TargetClass("vehicle-" + c.Name)
            {
                Colour = c.Range, MinSideMetres = 2.4, MaxSideMetres = 3.7, MinAspect = 1.7, MaxAspect = 2.8,
                MinColourShare = 0.7,
            }),
        new TargetClass("person")
        {
            Colour = Colours[1].Range, MinSideMetres = 0.75, MaxSideMetres = 1.1, MinAspect = 2.1, MaxAspect = 4.5,
        },
    ];

    /// <summary>Panels on the ground of photos: 0.4 m, black and white.</summary>
    public static ImmutableArray<TargetClass> BlackAndWhitePanels { get; } =
    [
        new TargetClass("panel-" + PhotoManifest.PanelColour)
        {
            Colour = new ColourRange(20, 20, 20),
            SecondColour = new ColourRange(240, 240, 240),
            MinSideMetres = 0.3,
            MaxSideMetres = 0.54,
        },
    ];

    public static string ColourOf(string name)
        => name == "person" ? "orange" : name.Substring(name.IndexOf('-') + 1);
}
