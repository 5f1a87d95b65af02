using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>How the classes of targets appear on the map of the screen.</summary>
internal static class TargetLetters
{
    private static readonly (TargetClassName Class, char Letter, MapInk Ink)[] Known =
    [
        (DefaultTargetClasses.Red, 'R', MapInk.Red),
        (DefaultTargetClasses.Orange, 'O', MapInk.Orange),
        (DefaultTargetClasses.Blue, 'B', MapInk.Blue),
        (DefaultTargetClasses.Yellow, 'Y', MapInk.Yellow),
        (DefaultTargetClasses.Magenta, 'M', MapInk.Magenta),
    ];

    /// <summary>Of the default classes their own, of others the first letter of the name; ! for no class.</summary>
    public static char Letter(TargetClassName targetClass)
        => Find(targetClass)?.Letter ?? (targetClass.IsNone ? '!' : char.ToUpperInvariant(targetClass.ToString()[0]));

    public static MapInk Ink(TargetClassName targetClass) => Find(targetClass)?.Ink ?? MapInk.Tentative;

    private static (TargetClassName Class, char Letter, MapInk Ink)? Find(TargetClassName targetClass)
    {
        foreach ((TargetClassName Class, char Letter, MapInk Ink) known in Known)
        {
            if (known.Class == targetClass)
                return known;
        }

        return null;
    }
}
