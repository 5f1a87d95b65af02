using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>How the classes of targets look to people: names, letters, colours.</summary>
internal static class Colours
{
    private static readonly (TargetClassName Class, char Letter, string Css, MapInk Ink)[] Known =
    [
        (DefaultTargetClasses.Red, 'R', "#cd1c20", MapInk.Red),
        (DefaultTargetClasses.Orange, 'O', "#f27012", MapInk.Orange),
        (DefaultTargetClasses.Blue, 'B', "#1c48cd", MapInk.Blue),
        (DefaultTargetClasses.Yellow, 'Y', "#f3d61c", MapInk.Yellow),
        (DefaultTargetClasses.Magenta, 'M', "#d42496", MapInk.Magenta),
    ];

    /// <summary>The name of a class of targets; "no class" where there is none.</summary>
    public static string Name(TargetClassName targetClass) => targetClass.IsNone ? "no class" : targetClass.ToString();

    /// <summary>One letter for a map: of the default classes their own, of others the first of the name; ! for no class.</summary>
    public static char Letter(TargetClassName targetClass)
        => Find(targetClass)?.Letter ?? (targetClass.IsNone ? '!' : char.ToUpperInvariant(targetClass.ToString()[0]));

    /// <summary>#rrggbb; grey for a class that is not one of the default ones.</summary>
    public static string Css(TargetClassName targetClass) => Find(targetClass)?.Css ?? "#808080";

    /// <summary>What it is drawn with on the map of the screen.</summary>
    public static MapInk Ink(TargetClassName targetClass) => Find(targetClass)?.Ink ?? MapInk.Tentative;

    private static (TargetClassName Class, char Letter, string Css, MapInk Ink)? Find(TargetClassName targetClass)
    {
        foreach ((TargetClassName Class, char Letter, string Css, MapInk Ink) known in Known)
        {
            if (known.Class == targetClass)
                return known;
        }

        return null;
    }
}
