using System.Linq;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>How the classes of targets are drawn on the map of the screen.</summary>
internal static class TargetLetters
{
    private static readonly (TargetColours Colour, char Letter, MapInk Ink)[] Known =
    [
        (TargetColours.Red, 'R', MapInk.Red),
        (TargetColours.Orange, 'O', MapInk.Orange),
        (TargetColours.Blue, 'B', MapInk.Blue),
        (TargetColours.Yellow, 'Y', MapInk.Yellow),
        (TargetColours.Magenta, 'M', MapInk.Magenta),
    ];

    /// <summary>! for what is not exactly one class.</summary>
    public static char Letter(TargetColours colour) => Known.FirstOrDefault(k => k.Colour == colour) is { Letter: not '\0' } known ? known.Letter : '!';

    public static MapInk Ink(TargetColours colour) => Known.FirstOrDefault(k => k.Colour == colour) is { Letter: not '\0' } known ? known.Ink : MapInk.Tentative;
}
