using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>The colours of targets for people: names, letters, and what they look like.</summary>
internal static class Colours
{
    private static readonly (TargetColours Colour, string Name, char Letter, string Css, MapInk Ink)[] Known =
    [
        (TargetColours.Red, "red", 'R', "#cd1c20", MapInk.Red),
        (TargetColours.Orange, "orange", 'O', "#f27012", MapInk.Orange),
        (TargetColours.Blue, "blue", 'B', "#1c48cd", MapInk.Blue),
        (TargetColours.Yellow, "yellow", 'Y', "#f3d61c", MapInk.Yellow),
        (TargetColours.Magenta, "magenta", 'M', "#d42496", MapInk.Magenta),
    ];

    public static string AllNames => string.Join(", ", Known.Select(k => k.Name));

    /// <summary>Its name in small letters; several are joined, none is "no colour".</summary>
    public static string Name(TargetColours colours)
    {
        IEnumerable<string> names = Known.Where(k => (colours & k.Colour) != 0).Select(k => k.Name);
        return string.Join("+", names.DefaultIfEmpty("no colour"));
    }

    /// <summary>One letter for a map; ! for what is not exactly one colour.</summary>
    public static char Letter(TargetColours colour) => Find(colour)?.Letter ?? '!';

    /// <summary>#rrggbb.</summary>
    public static string Css(TargetColours colour) => Find(colour)?.Css ?? "#808080";

    /// <summary>What it is drawn with on the map of the screen.</summary>
    public static MapInk Ink(TargetColours colour) => Find(colour)?.Ink ?? MapInk.Tentative;

    public static bool TryParse(string name, out TargetColours colour)
    {
        colour = Known.FirstOrDefault(k => string.Equals(k.Name, name, StringComparison.OrdinalIgnoreCase)).Colour;
        return colour != TargetColours.None;
    }

    private static (TargetColours Colour, string Name, char Letter, string Css, MapInk Ink)? Find(TargetColours colour)
    {
        foreach ((TargetColours Colour, string Name, char Letter, string Css, MapInk Ink) known in Known)
        {
            if (known.Colour == colour)
                return known;
        }

        return null;
    }
}
