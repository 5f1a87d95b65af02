using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>The classes of targets as texts, in files and for people.</summary>
public static class TargetClassNames
{
    private static readonly (TargetColours Colour, string Name, string Css)[] Known =
    [
        (TargetColours.Red, "red", "#cd1c20"),
        (TargetColours.Orange, "orange", "#f27012"),
        (TargetColours.Blue, "blue", "#1c48cd"),
        (TargetColours.Yellow, "yellow", "#f3d61c"),
        (TargetColours.Magenta, "magenta", "#d42496"),
    ];

    /// <summary>All names, for messages to people: "red, orange, ...".</summary>
    public static string All => string.Join(", ", Known.Select(k => k.Name));

    /// <summary>Returns the name in small letters; several are joined by +, none is "no colour".</summary>
    /// <param name="colours">One class or several.</param>
    public static string Name(TargetColours colours)
    {
        IEnumerable<string> names = Known.Where(k => (colours & k.Colour) != 0).Select(k => k.Name);
        return string.Join("+", names.DefaultIfEmpty("no colour"));
    }

    /// <summary>Finds a class by its name, in any case.</summary>
    /// <param name="name">One name.</param>
    /// <param name="colour">The class; none where the name is not known.</param>
    public static bool TryParse(string name, out TargetColours colour)
    {
        colour = Known.FirstOrDefault(k => string.Equals(k.Name, name, StringComparison.OrdinalIgnoreCase)).Colour;
        return colour != TargetColours.None;
    }

    /// <summary>#rrggbb; grey for what is not exactly one class.</summary>
    internal static string Css(TargetColours colour) => Known.FirstOrDefault(k => k.Colour == colour).Css ?? "#808080";
}
