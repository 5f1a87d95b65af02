using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>How the classes of targets are shown to people.</summary>
public static class TargetClassNames
{
    private static readonly (TargetClassName Class, string Css)[] Known =
    [
        (DefaultTargetClasses.Red, "#cd1c20"),
        (DefaultTargetClasses.Orange, "#f27012"),
        (DefaultTargetClasses.Blue, "#1c48cd"),
        (DefaultTargetClasses.Yellow, "#f3d61c"),
        (DefaultTargetClasses.Magenta, "#d42496"),
    ];

    /// <summary>Returns the name of a class; "no class" where there is none.</summary>
    /// <param name="targetClass">A default class or one of the user's.</param>
    public static string Name(TargetClassName targetClass) => targetClass.IsNone ? "no class" : targetClass.ToString();

    /// <summary>#rrggbb; grey for a class that is not one of the default ones.</summary>
    internal static string Css(TargetClassName targetClass)
    {
        foreach ((TargetClassName Class, string Css) known in Known)
        {
            if (known.Class == targetClass)
                return known.Css;
        }

        return "#808080";
    }
}
